#include "support/small_dataset/small_dataset.hpp"

#include "store/mesh_arrays.hpp"
#include "store/writer.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <algorithm>
#include <cmath>

namespace ciel::test {
using namespace server;
namespace {

Vec3d offset(std::span<const float> positions, Index vertex) {
    const float* at = &positions[std::size_t{3} * vertex];
    return {at[0], at[1], at[2]};
}

// All kinds of cells, with a cubic hole of side 2 in the middle.
Polyhedra box_with_hole() {
    Polyhedra mesh = zoo({{6, 6, 6}, 0, 5, 1});
    mesh.origin = box_origin;
    return keep_cells(mesh, [&](Id cell) {
        Vec3d middle{};
        double corners = 0;
        for (const Loop& loop : mesh.loops(cell))
            for (const Id vertex : loop) {
                for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] += mesh.positions[3 * vertex + axis];
                ++corners;
            }
        return std::any_of(middle.begin(), middle.end(), [&](double sum) { return std::abs(sum / corners - 3) > 1; });
    });
}

std::vector<Index> boundary_faces(const FaceMesh& mesh, bool (*belongs)(const Vec3d& vertex)) {
    std::vector<Index> faces;
    const FaceMeshView view = mesh.view();
    for (Index face = 0; face < view.face_count(); ++face) {
        const auto loop = view.loop(face);
        if (mesh.neighbour[face] == none &&
            std::all_of(loop.begin(), loop.end(), [&](Index v) { return belongs(offset(mesh.positions, v)); }))
            faces.push_back(face);
    }
    return faces;
}

struct Arrays {
    std::vector<float> p, u, q;

    [[nodiscard]] std::vector<store::ArrayValues> views(bool with_late) const {
        using store::Association;
        std::vector<store::ArrayValues> list{{{"p", Association::point, 1, "Pa", "pressure"}, p},
                                             {{"U", Association::point, 3, "m/s", "velocity"}, u},
                                             {{"cell:q", Association::cell, 1, "", ""}, q}};
        if (with_late) list.push_back({{"late", Association::point, 1, "", ""}, p});
        return list;
    }
};

Arrays arrays_at(std::span<const float> positions, std::span<const Index> original_cell, double time) {
    Arrays arrays;
    for (Index vertex = 0; vertex < positions.size() / 3; ++vertex) {
        const Vec3d at = offset(positions, vertex);
        arrays.p.push_back(static_cast<float>(pressure(at, time)));
        for (const double component : velocity(at)) arrays.u.push_back(static_cast<float>(component));
    }
    for (const Index cell : original_cell) arrays.q.push_back(static_cast<float>(cell));
    return arrays;
}

} // namespace

void write_small_dataset(const std::filesystem::path& directory) {
    const Polyhedra input = box_with_hole();
    const Assembled assembled = assemble(view(input));
    const FaceMesh& mesh = assembled.mesh;
    std::vector<Index> half(mesh.cell_types.size() / 2);
    for (Index i = 0; i < half.size(); ++i) half[i] = i;
    const std::vector<store::NamedGroup> groups{
        {store::Group::Of::faces, "left", boundary_faces(mesh, [](const Vec3d& v) { return v[0] == 0; })},
        {store::Group::Of::faces, "body",
         boundary_faces(mesh,
                        [](const Vec3d& v) {
                            return std::all_of(v.begin(), v.end(), [](double x) { return x >= 2 && x <= 4; });
                        })},
        {store::Group::Of::cells, "half", half}};
    store::Writer writer(directory, {"a generator", "m", input.vertex_count(), 0, input.cell_count(), {}});
    writer.add_mesh(mesh, assembled.original_vertex, assembled.original_cell, groups);
    for (const double time : {0.0, 1.0, 2.0}) {
        const Arrays arrays = arrays_at(mesh.positions, assembled.original_cell, time);
        writer.add_step(time, 0, 0, arrays.views(time == 2));
    }
    writer.finish();
}

void append_step(const std::filesystem::path& directory, double time) {
    const auto dataset = store::Dataset::open(directory);
    const Arrays arrays =
        arrays_at(dataset->mesh_arrays().points(0, 0).positions.floats(), dataset->original_cell(0), time);
    auto writer = store::Writer::append(directory);
    writer.add_step(time, 0, 0, arrays.views(true));
    writer.finish();
}

} // namespace ciel::test
