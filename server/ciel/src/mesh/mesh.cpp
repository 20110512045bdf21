#include "ciel/mesh.hpp"

#include "ciel/cell_fits.hpp"
#include "mesh/polyhedra_lists.hpp"

#include <string>

namespace ciel {

using namespace detail;

struct Mesh::State {
    std::shared_ptr<const void> faces_owner;    // owns the arrays of `faces`, except moved positions
    std::shared_ptr<const Assembled> assembled; // null for a mesh made by from_stored
    std::shared_ptr<const Topology> topology;
    std::vector<Index> original_cell;
    FaceMeshView faces;
    std::shared_ptr<CellFits> cell_fits; // for the positions of `faces`
    MeshReport report;
    std::size_t points = 0, cells = 0;
};

namespace {

// Returns the number of cells of a mesh whose last cell has this id. A negative id means no cell.
std::size_t cells_with(std::int64_t last) { return last < 0 ? 0 : static_cast<std::size_t>(last) + 1; }

// Cell indices in PolyhedraLists differ from the caller's ids, because the lists leave out cells without volume.
void name_source_cells(const std::vector<Index>& source, AssembleReport& report) {
    const auto name = [&source](std::vector<Index>& ids) {
        for (Index& id : ids) id = source[id];
    };
    for (BadCells& bad : report.bad_cells) name(bad.first_ids);
    name(report.first_short);
    name(report.first_inverted);
}

} // namespace

template <class Put>
Mesh Mesh::make(const ArrayView& points, std::size_t cells, const Put& put) {
    PolyhedraLists lists;
    put_points(points, lists);
    put(lists);
    auto state = std::make_shared<State>();
    auto assembled = std::make_shared<Assembled>(assemble(lists.view()));
    state->points = points.rows();
    state->cells = cells;
    state->report.assembled = assembled->report;
    state->report.skipped_cells = lists.skipped;
    state->report.reduced_cells = lists.reduced;
    state->report.bytes_copied = lists.bytes();
    name_source_cells(lists.source_cell, state->report.assembled);
    state->original_cell = assembled->original_cell;
    for (Index& cell : state->original_cell) cell = lists.source_cell[cell];
    state->faces = assembled->mesh.view();
    state->faces_owner = state->faces.keep_alive = assembled;
    state->faces.surface_origin = middle_of(points);
    state->topology = std::make_shared<const Topology>(state->faces);
    state->cell_fits = std::make_shared<CellFits>(*state->topology);
    state->assembled = std::move(assembled);
    return Mesh(std::move(state));
}

Mesh Mesh::from_polyhedra(const ArrayView& points, const ArrayView& cell_offset, const ArrayView& face_offset,
                          const ArrayView& face_vertex) {
    return make(points, cell_offset.empty() ? 0 : cell_offset.rows() - 1,
                [&](PolyhedraLists& lists) { put_polyhedra(cell_offset, face_offset, face_vertex, lists); });
}

Mesh Mesh::from_faces(const ArrayView& points, const ArrayView& face_offset, const ArrayView& face_vertex,
                      const ArrayView& owner, const ArrayView& neighbour) {
    std::size_t cells = 0;
    for (std::size_t face = 0; face < owner.rows(); ++face) cells = std::max(cells, cells_with(owner.integer(face)));
    for (std::size_t face = 0; face < neighbour.rows(); ++face)
        cells = std::max(cells, cells_with(neighbour.integer(face)));
    return make(points, cells,
                [&](PolyhedraLists& lists) { put_owner_faces(face_offset, face_vertex, owner, neighbour, lists); });
}

Mesh Mesh::from_cells(const ArrayView& points, const VtkCells& cells) {
    return make(points, cells.types.rows(), [&](PolyhedraLists& lists) { put_vtk_cells(cells, lists); });
}

Mesh Mesh::from_stored(const FaceMeshView& faces) {
    auto state = std::make_shared<State>();
    state->faces = faces.owned();
    if (faces.loader != nullptr) faces.loader->load(0, faces.vertex_count());
    state->faces.loader = nullptr;
    state->faces_owner = faces.keep_alive;
    state->topology = std::make_shared<const Topology>(faces);
    state->cell_fits = std::make_shared<CellFits>(*state->topology);
    state->points = faces.vertex_count();
    state->cells = faces.cell_count();
    return Mesh(std::move(state));
}

Mesh Mesh::moved(const ArrayView& points) const {
    if (points.columns() != 3 || points.rows() != state_->points)
        fail("moved points must be " + std::to_string(state_->points) +
             " rows of three numbers, one row per point of the mesh");
    struct Owners {
        std::shared_ptr<const void> of_faces;
        MeshPoints points;
    };
    const auto owners =
        std::make_shared<const Owners>(Owners{state_->faces_owner, mesh_points(points, original_vertex())});
    auto state = std::make_shared<State>(*state_);
    state->faces.keep_alive = owners;
    state->faces.origin = {};
    state->faces.positions = owners->points.view();
    state->cell_fits = std::make_shared<CellFits>(*state->topology);
    state->report.bytes_copied += state->faces.positions.size_bytes();
    return Mesh(std::move(state));
}

std::size_t Mesh::point_count() const { return state_->points; }
std::size_t Mesh::cell_count() const { return state_->cells; }
const MeshReport& Mesh::report() const { return state_->report; }
const Topology& Mesh::topology() const { return *state_->topology; }
const FaceMeshView& Mesh::stored() const { return state_->faces; }
const std::shared_ptr<CellFits>& Mesh::cell_fits() const { return state_->cell_fits; }

std::span<const Index> Mesh::original_vertex() const {
    if (!state_->assembled) return {};
    return state_->assembled->original_vertex;
}
std::span<const Index> Mesh::original_cell() const { return state_->original_cell; }

} // namespace ciel
