#include "store/rewrite.hpp"

#include "store/files/files.hpp"
#include "store/format/layout.hpp"
#include "store/mesh_arrays.hpp"
#include "store/writer.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace server::store {
namespace {

ciel::FaceMesh copy_of(const ciel::FaceMeshView& view) {
    ciel::FaceMesh mesh;
    mesh.origin = view.origin;
    view.positions.with([&]<class Number>(std::span<const Number> all) {
        mesh.set_positions(std::vector<Number>(all.begin(), all.end()));
    });
    mesh.cell_types.assign(view.cell_types.begin(), view.cell_types.end());
    mesh.face_offset.assign(view.face_offset.begin(), view.face_offset.end());
    mesh.face_vertex.assign(view.face_vertex.begin(), view.face_vertex.end());
    mesh.owner.assign(view.owner.begin(), view.owner.end());
    mesh.neighbour.assign(view.neighbour.begin(), view.neighbour.end());
    return mesh;
}

std::pair<std::array<ciel::Index, 2>, std::vector<ciel::Index>> key_of(const ciel::FaceMeshView& mesh,
                                                                       ciel::Index face) {
    const ciel::Ids loop = mesh.loop(face);
    std::pair<std::array<ciel::Index, 2>, std::vector<ciel::Index>> key{{mesh.owner[face], mesh.neighbour[face]},
                                                                        {loop.begin(), loop.end()}};
    std::ranges::sort(key.second);
    return key;
}

// Returns for each numbered face (mesh_arrays.hpp) its id in `all`. Boundary faces have the same order in both meshes.
std::vector<ciel::Index> ids_of_numbers(const ciel::FaceMeshView& all, const ciel::FaceMeshView& numbered) {
    std::vector<ciel::Index> ids;
    std::map<std::pair<std::array<ciel::Index, 2>, std::vector<ciel::Index>>, ciel::Index> inner;
    for (ciel::Index number = 0; number < numbered.face_count(); ++number)
        if (numbered.neighbour[number] != ciel::none) inner.emplace(key_of(numbered, number), number);
    std::set<std::array<ciel::Index, 2>> cells; // the two cells of each face in `inner`
    for (const auto& [key, number] : inner) cells.insert(key.first);
    for (ciel::Index face = 0; face < all.face_count(); ++face)
        if (all.neighbour[face] == ciel::none) ids.push_back(face);
    ids.resize(numbered.face_count(), ciel::none);
    for (ciel::Index face = 0; face < all.face_count(); ++face) {
        if (!cells.contains({all.owner[face], all.neighbour[face]})) continue;
        if (const auto found = inner.find(key_of(all, face)); found != inner.end()) ids[found->second] = face;
    }
    return ids;
}

std::vector<NamedGroup> groups_of(const Dataset& dataset, std::size_t mesh, const ciel::FaceMeshView& all) {
    const std::vector<ciel::Index> id = ids_of_numbers(all, dataset.mesh_arrays().numbered_faces(mesh, 0));
    std::vector<NamedGroup> groups;
    for (const Group& group : dataset.groups(mesh)) {
        NamedGroup named{group.of, group.name, {group.ids.begin(), group.ids.end()}, group.facts};
        if (group.of == Group::Of::faces)
            for (ciel::Index& face : named.ids) face = id.at(face);
        groups.push_back(std::move(named));
    }
    return groups;
}

class Rewriter {
public:
    Rewriter(const Dataset& from, Writer& to, const std::function<void(double)>& progress)
        : from_(from), to_(to), progress_(progress),
          total_(static_cast<double>(from.info().meshes.size() + from.steps().size())) {}

    std::vector<std::string> run() {
        for (std::size_t mesh = 0; mesh < from_.info().meshes.size(); ++mesh) {
            tell_progress();
            const ciel::FaceMeshView all = from_.mesh_arrays().all_faces(mesh, 0);
            to_.add_mesh(copy_of(all), from_.original_vertex(mesh), from_.original_cell(mesh),
                         groups_of(from_, mesh, all), {from_.solver_vertex(mesh), from_.solver_cell(mesh)});
        }
        for (std::size_t step = 0; step < from_.steps().size(); ++step) {
            tell_progress();
            add_step(step);
        }
        return std::move(left_out_);
    }

private:
    void tell_progress() { progress_(done_++ / total_); }

    void add_step(std::size_t index) {
        const Step& step = from_.steps()[index];
        std::size_t& sets = sets_.try_emplace(step.mesh, 1).first->second;
        for (; sets <= step.coordinates; ++sets)
            (void)to_.add_coordinates(step.mesh, from_.mesh_arrays().points(step.mesh, sets).positions);
        to_.begin_step(step.time, step.mesh, step.coordinates);
        for (const auto& [name, array] : step.arrays) add_array(name, array, index);
        to_.end_step();
    }

    void add_array(const std::string& name, const ArrayStep& array, std::size_t step) {
        Values values;
        try {
            values = from_.values(name, step);
        } catch (const ciel::Error& error) {
            if (!array.late) throw;
            left_out_.push_back(std::string("An array was left out: ") + error.what() + ".");
            return;
        }
        to_.add_values({*from_.find(name), values});
    }

    const Dataset& from_;
    Writer& to_;
    const std::function<void(double)>& progress_;
    double done_ = 0, total_;
    std::map<std::size_t, std::size_t> sets_;
    std::vector<std::string> left_out_;
};

} // namespace

bool is_dataset(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::exists(path / layout::commit_marker, error);
}

std::vector<std::string> rewrite(const std::filesystem::path& from, const std::filesystem::path& to, bool overwrite,
                                 const std::function<void(double)>& progress) {
    const auto dataset = Dataset::open(from, LackingRanges::left_out);
    const DatasetInfo& info = dataset->info();
    for (std::size_t step = 0; step < dataset->steps().size() && !info.late.inputs.empty(); ++step)
        if (!dataset->late_chunks(step).empty())
            refuse(from, "has steps that have not been read from their source; read them first with `ciel import " +
                             from.filename().string() + " --all`");
    Writer writer(to,
                  {info.source, info.length_units, info.input_vertices, info.input_edges, info.input_cells, info.notes},
                  overwrite);
    std::vector<std::string> left_out = Rewriter(*dataset, writer, progress).run();
    for (const std::string& sentence : left_out) writer.add_note(sentence);
    dataset->check_intact();
    writer.finish();
    return left_out;
}

} // namespace server::store
