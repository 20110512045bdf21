#include "store/write_mesh.hpp"

#include "store/cache/stored_blocks.hpp"
#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/format/layout.hpp"
#include "store/format/number_groups.hpp"
#include "store/format/value_ranges.hpp"
#include "store/mesh_counts.hpp"
#include "store/write_blocks.hpp"
#include "store/written_points.hpp"

#include <algorithm>
#include <cmath>

namespace server::store {
namespace {

namespace fs = std::filesystem;

void write_group(const fs::path& directory) {
    make_directory(directory);
    write_file(directory / layout::group_document, bytes_of(group_text()));
}

std::string write_whole(const fs::path& directory, ElementType type, std::span<const std::byte> bytes) {
    make_directory(directory);
    write_file(directory / layout::array_document,
               bytes_of(to_text(whole_array(type, bytes.size() / element_bytes(type)))));
    if (!bytes.empty()) write_file(layout::chunk(directory, 0, 1), bytes);
    return checksum(bytes);
}

void check_sizes(const ciel::FaceMesh& mesh, ciel::ValuesView positions, const OriginalIds& original) {
    if (mesh.cell_types.empty() || positions.empty()) throw ciel::Error("the mesh has no cells; nothing can be stored");
    if (positions.size() != 3 * original.vertex.size() || mesh.cell_types.size() != original.cell.size() ||
        mesh.owner.size() != mesh.neighbour.size() || mesh.face_offset.size() != mesh.owner.size() + 1 ||
        mesh.face_offset.back() != mesh.face_vertex.size())
        throw ciel::Error("the arrays of the mesh do not have matching sizes");
    check_finite(positions);
}

void check_solver_ids(const SolverIds& solver, std::size_t vertices, std::size_t cells) {
    if ((!solver.vertex.empty() && solver.vertex.size() != vertices) ||
        (!solver.cell.empty() && solver.cell.size() != cells))
        throw ciel::Error("the ids of the solver must be one per vertex and one per cell");
}

void check_group(const NamedGroup& group, std::size_t limit) {
    for (const ciel::Index id : group.ids)
        if (id >= limit)
            throw ciel::Error("group '" + group.name + "' contains id " + std::to_string(id) +
                              ", but ids must be less than " + std::to_string(limit));
}

void write_ranges(const fs::path& array, std::size_t index, const ValueRanges& ranges, const std::string& dataset_id,
                  std::span<const std::byte> chunk) {
    const fs::path file = layout::value_ranges(array, index);
    make_directory(file.parent_path());
    write_file(file, to_bytes(ranges, dataset_id, checksum_number(chunk)));
}

// Writes the positions before the blocks are built, so that the positions copied from `cells` are freed by then.
MeshAttributes write_positions(const fs::path& directory, const NewMesh& added, const OriginalIds& original) {
    const ciel::FaceMesh made = added.cells != nullptr ? added.cells->points() : ciel::FaceMesh{};
    const ciel::FaceMesh& points = added.cells != nullptr ? made : added.mesh;
    const ciel::ValuesView positions = points.view().positions;
    check_sizes(added.mesh, positions, original);
    write_group(directory);
    make_directory(directory / "positions");
    write_file(layout::chunk(directory / "positions", 0, 3), positions.bytes());
    MeshAttributes attributes;
    attributes.origin = points.origin;
    attributes.coordinate_checksums.push_back(checksum(positions.bytes()));
    attributes.info.vertices = positions.size() / 3;
    attributes.info.double_positions = positions.has_doubles();
    attributes.info.bounds = bounds_of(points.origin, positions);
    return attributes;
}

// Writes arrays of one chunk, and adds their checksums to the attributes of the mesh.
class ArrayFiles {
public:
    ArrayFiles(fs::path directory, const std::string& dataset_id, MeshAttributes& attributes)
        : directory_(std::move(directory)), dataset_id_(dataset_id), attributes_(attributes) {}

    void write(const std::string& name, ElementType type, std::span<const std::byte> bytes) {
        attributes_.checksums[name] = write_whole(directory_ / name, type, bytes);
    }
    void write_ids(const std::string& name, ElementType type, std::span<const std::byte> ids) {
        write(name, type, ids);
        write_ranges(directory_ / name, 0, {{}, {}, stretch_checksums(ids)}, dataset_id_, ids);
    }

private:
    fs::path directory_;
    const std::string& dataset_id_;
    MeshAttributes& attributes_;
};

// `mesh`: all faces, or the boundary faces.
void write_faces_and_groups(const fs::path& directory, const ciel::FaceMeshView& mesh,
                            std::span<const NamedGroup> groups, ArrayFiles& files, MeshAttributes& attributes) {
    std::vector<std::vector<ciel::Index>> ids; // by group; empty for groups of cells
    for (const NamedGroup& group : groups) {
        check_group(group, group.of == Group::Of::faces ? mesh.face_count() : mesh.cell_count());
        ids.push_back(group.of == Group::Of::faces ? group.ids : std::vector<ciel::Index>{});
    }
    const NumberedGroups numbered = number_groups(mesh, ids);
    write_group(directory / layout::faces_group);
    files.write("faces/face_offset", ElementType::u8, std::as_bytes(std::span(numbered.faces.face_offset)));
    files.write("faces/face_vertex", ElementType::u4, std::as_bytes(std::span(numbered.faces.face_vertex)));
    files.write("faces/owner", ElementType::u4, std::as_bytes(std::span(numbered.faces.owner)));
    files.write("faces/neighbour", ElementType::u4, std::as_bytes(std::span(numbered.faces.neighbour)));
    write_group(directory / "groups");
    for (std::size_t i = 0; i < groups.size(); ++i) {
        std::vector<ciel::Index> of_group = groups[i].of == Group::Of::faces ? numbered.ids[i] : groups[i].ids;
        std::sort(of_group.begin(), of_group.end());
        of_group.erase(std::unique(of_group.begin(), of_group.end()), of_group.end());
        const std::string name = "groups/" + std::to_string(i);
        files.write(name, ElementType::u4, std::as_bytes(std::span(of_group)));
        attributes.groups.push_back({groups[i].of, groups[i].name, groups[i].facts});
        write_file(directory / name / layout::attributes_document,
                   bytes_of(group_attributes_text(attributes.groups.back())));
    }
}

} // namespace

void write_boxes(const fs::path& directory, const ciel::Topology& topology, const std::string& dataset_id,
                 std::size_t coordinates, ciel::ValuesView positions) {
    ciel::BlockBoxes boxes = ciel::block_boxes(topology, positions);
    const ValueRanges ranges{
        {std::move(boxes[0]), std::move(boxes[1]), std::move(boxes[2])}, {}, stretch_checksums(positions.bytes())};
    write_ranges(directory / "positions", coordinates, ranges, dataset_id, positions.bytes());
}

void check_finite(ciel::ValuesView positions) {
    positions.with([](const auto& all) {
        const auto bad = std::find_if(all.begin(), all.end(), [](auto v) { return !std::isfinite(v); });
        if (bad != all.end())
            throw ciel::Error("vertex " + std::to_string((bad - all.begin()) / 3) +
                              " has a coordinate that is not a finite number; correct the coordinate");
    });
}

ZarrArray positions_shape(std::uint64_t sets, const MeshInfo& mesh) {
    return {mesh.double_positions ? ElementType::f8 : ElementType::f4, {sets, mesh.vertices, 3}, {1, mesh.vertices, 3}};
}

ZarrArray values_shape(std::uint64_t steps, std::uint64_t items, const ArrayInfo& of) {
    ZarrArray array{of.doubles ? ElementType::f8 : ElementType::f4, {steps, items}, {1, items}};
    if (of.components > 1) {
        array.shape.push_back(static_cast<std::uint64_t>(of.components));
        array.chunks.push_back(static_cast<std::uint64_t>(of.components));
    }
    return array;
}

MeshAttributes write_mesh(const fs::path& directory, const NewMesh& added, const OriginalIds& original,
                          std::span<const NamedGroup> groups, const SolverIds& solver, const std::string& dataset_id) {
    const ciel::FaceMesh& mesh = added.mesh;
    check_solver_ids(solver, original.vertex.size(), original.cell.size());
    MeshAttributes attributes = write_positions(directory, added, original);
    write_group(directory / "arrays");
    const std::array<double, 6> bounds = attributes.info.bounds;
    const ciel::TopologyCounts counts = added.cells != nullptr
                                            ? write_blocks(directory, *added.cells, dataset_id, bounds)
                                            : write_blocks(directory, mesh.view(), dataset_id, bounds);
    const WrittenPoints points(directory, attributes, 0);
    const ciel::ValuesView positions = points.view().positions;
    const ciel::FaceMeshView view = ciel::face_mesh_view(mesh.origin, positions, mesh.cell_types, mesh.face_offset,
                                                         mesh.face_vertex, mesh.owner, mesh.neighbour);
    attributes.info = count_mesh(view, counts, bounds);

    ArrayFiles files(directory, dataset_id, attributes);
    files.write("cell_types", ElementType::u1, std::as_bytes(std::span(mesh.cell_types)));
    files.write_ids("original_vertex", ElementType::u4, std::as_bytes(original.vertex));
    files.write_ids("original_cell", ElementType::u4, std::as_bytes(original.cell));
    if (!solver.vertex.empty()) files.write_ids("solver_vertex", ElementType::i8, std::as_bytes(solver.vertex));
    if (!solver.cell.empty()) files.write_ids("solver_cell", ElementType::i8, std::as_bytes(solver.cell));
    write_faces_and_groups(directory, view, groups, files, attributes);
    const auto blocks = std::make_shared<const StoredBlocks>(directory, dataset_id);
    write_boxes(directory, blocks->topology(), dataset_id, 0, positions);
    return attributes;
}

} // namespace server::store
