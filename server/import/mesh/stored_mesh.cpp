#include "import/mesh/stored_mesh.hpp"

#include "store/mesh_arrays.hpp"

#include <algorithm>

namespace server::importer {
namespace {

ciel::FaceMesh copy_boundary(const ciel::FaceMeshView& stored) {
    ciel::FaceMesh boundary;
    boundary.origin = stored.origin;
    boundary.cell_types.assign(stored.cell_types.begin(), stored.cell_types.end());
    for (ciel::Index face = 0; face < stored.face_count(); ++face) {
        const auto loop = stored.loop(face).unchecked();
        boundary.face_vertex.insert(boundary.face_vertex.end(), loop.begin(), loop.end());
        boundary.face_offset.push_back(boundary.face_vertex.size());
        boundary.owner.push_back(stored.owner[face]);
        boundary.neighbour.push_back(ciel::none);
    }
    return boundary;
}

} // namespace

std::optional<StepMesh> stored_mesh(const store::Dataset& dataset, const InputGrids& input_grids) {
    JoinedMesh joined = number_members(input_grids.volumes);
    const ciel::FaceMeshView points = dataset.mesh_arrays().points(0, 0);
    const auto vertices = dataset.original_vertex(0);
    const auto cells = dataset.original_cell(0);
    const RunningCounts counts = count_running(input_grids.volumes);
    const auto are_below = [](std::span<const ciel::Index> ids, ciel::Index count) {
        return std::ranges::all_of(ids, [count](ciel::Index id) { return id < count; });
    };
    if (vertices.size() != points.vertex_count() || cells.size() != points.cell_count() ||
        !are_below(vertices, counts.points) || !are_below(cells, counts.cells) ||
        dataset.info().input_vertices != counts.points)
        return std::nullopt;
    StepMesh mesh;
    mesh.point_count = joined.point_count;
    mesh.boundary = copy_boundary(dataset.mesh_arrays().boundary(0, 0));
    mesh.positions = store::Values(points.positions, points.keep_alive);
    mesh.point_of_vertex.assign(vertices.begin(), vertices.end());
    mesh.cell_of_cell.assign(cells.begin(), cells.end());
    mesh.patches = match_patches(mesh.view(), mesh.point_of_vertex, joined, {}, input_grids.surfaces);
    mesh.members = std::move(joined.members);
    return mesh;
}

} // namespace server::importer
