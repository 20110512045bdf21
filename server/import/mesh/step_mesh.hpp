// One mesh of the input, with the vertices and cells in the order of the dataset (stored ids). Maps lead from stored
// ids to running ids (joined_mesh.hpp).
#pragma once

#include "import/mesh/joined_mesh.hpp"
#include "import/mesh/patches.hpp"
#include "import/mesh/welds.hpp"
#include "store/writer.hpp"

#include <memory>

namespace server::importer {

// The cells of a mesh that is not yet written.
struct NewCells {
    explicit NewCells(std::shared_ptr<const JoinedMesh> mesh)
        : joined(std::move(mesh)), matched(joined->view(), joined) {}

    std::shared_ptr<const JoinedMesh> joined;
    ciel::MatchedCells matched;
};

struct StepMesh {
    std::vector<JoinedMesh::Member> members; // with the data of the step that was read last
    ciel::Index point_count = 0;
    std::unique_ptr<NewCells> cells;          // null after the mesh has been written
    ciel::FaceMesh boundary;                  // types of the cells, and the boundary faces; without positions
    store::Values positions;                  // x, y, z of each stored vertex; empty while the mesh is written
    std::vector<ciel::Index> point_of_vertex; // stored vertex -> running point
    std::vector<ciel::Index> cell_of_cell;    // stored cell -> running cell
    std::vector<Patch> patches;
    std::vector<Seam> seams;  // welded seams only
    PointPairs joined_pieces; // running points joined between pieces
    // True if no points were welded, the volumes are not pieces of one mesh, and none has cells of dimension 2. Then
    // stored_mesh() can make the StepMesh of a later step from the dataset.
    bool may_be_stored_mesh = false;
    std::vector<store::NamedGroup> groups;
    std::uint64_t input_vertices = 0, input_edges = 0, input_cells = 0; // before welding and removal of bad cells
    std::uint64_t bad_cells = 0;
    std::vector<std::string> notes;

    [[nodiscard]] ciel::FaceMeshView view() const {
        return ciel::face_mesh_view(boundary.origin, positions, boundary.cell_types, boundary.face_offset,
                                    boundary.face_vertex, boundary.owner, boundary.neighbour);
    }
};

// `folder`: as in JoinedMesh. Throws Error if no volume cell is usable, and for the errors of join_input_grids().
[[nodiscard]] StepMesh build_step_mesh(const InputGrids& input_grids, Weld weld, const SeamDifference& difference,
                                       const std::filesystem::path& folder);

// `input_grids`: another step with the same cells. If `moved` is true, also replaces the positions of the mesh.
void update_step_mesh(StepMesh& mesh, const InputGrids& input_grids, bool moved);

// Returns the values in stored order. `running`: `components` values per running point or cell. `stored_to_running`:
// point_of_vertex or cell_of_cell.
[[nodiscard]] store::Values to_stored(ciel::ValuesView running, std::span<const ciel::Index> stored_to_running,
                                      int components);

// Returns the solver ids in stored order. `running`: one id per running point or cell; if empty, the result is empty.
[[nodiscard]] std::vector<std::int64_t> to_stored(std::span<const std::int64_t> running,
                                                  std::span<const ciel::Index> stored_to_running);

} // namespace server::importer
