// First half of the paper's Algorithm 5 (appendix A): finds the two cells of each face of a mesh. The cells are given
// as lists of faces. The second half is Topology (topology.hpp), which builds the half-edges.
#pragma once

#include "ciel/face_mesh.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ciel {

// Cells as lists of faces, and faces as loops of vertex ids. Standard cells may list their corners instead, which takes
// less memory. V: number of vertices, C: number of cells, F: number of listed faces. Does not own the arrays.
// A listed face belongs to one cell and may have any winding. A face between two cells is listed twice, once for each
// cell. Collapsed cells are allowed: a loop may repeat vertex ids, and a face may have collapsed to a line or a point.
// A cell is closed when each of its half-edges between distinct vertices has a half-edge of the cell in the opposite
// direction.
// A face with fewer than three vertices is ignored. The other faces of the cell decide whether the cell is kept.
struct PolyhedraView {
    Vec3d origin{};
    ValuesView positions;                     // 3 V: x, y, z of each vertex, as offsets from `origin`
    std::span<const std::uint8_t> cell_types; // C: a CellType for each cell
    // C + 1: cell c has the faces cell_offset[c] to cell_offset[c + 1] - 1; empty if no cell lists faces
    std::span<const std::uint64_t> cell_offset;
    std::span<const std::uint64_t> face_offset; // F + 1: index of the first vertex of face f in face_vertex
    std::span<const Index> face_vertex;
    // C + 1: index of the first corner of cell c in `corner`; empty if all cells list their faces. A cell with corners
    // lists no faces. It has the faces of append_standard_faces.
    std::span<const std::uint64_t> corner_offset = {};
    std::span<const Index> corner = {}; // vertices, in VTK's order of the corners
};

// Cells that assemble() left out for one reason. A face between such a cell and a kept cell becomes a boundary face.
// Exception: the neighbors of a repeated cell are matched with the first copy of the cell.
struct BadCells {
    enum class Reason : std::uint8_t {
        open,
        inconsistent_winding,
        inside_out_unresolved,
        index_out_of_range,
        too_few_faces,
        repeated // has the same faces as an earlier cell, which is kept
    };
    Reason reason;
    std::uint64_t count = 0;
    std::vector<Index> first_ids; // input ids of the first 10 of these cells
};

struct AssembleReport {
    std::vector<BadCells> bad_cells;  // one entry for each reason that occurred
    std::uint64_t reversed_cells = 0; // cells of which all faces were reversed to point outwards
    // Number of reversed faces in cells that also have faces that were not reversed.
    std::uint64_t reversed_faces = 0;
    // Number of faces inside the mesh that were left unmatched, and so became boundary faces. Such a face has three or
    // more cells, or its two cells cannot be wound consistently.
    std::uint64_t internal_boundaries = 0;
    std::uint64_t short_faces = 0;  // faces with fewer than three vertices in cells that are kept
    std::vector<Index> first_short; // input ids of the first 10 cells with short faces
    // Cells that are kept with a negative volume, for example in folded curvilinear grids. If such a cell were
    // reversed, its winding would contradict the winding of its neighbors.
    std::uint64_t inverted_cells = 0;
    std::vector<Index> first_inverted; // input ids of the first 10 inverted cells
};

struct Assembled {
    // Cells are in the order of a space-filling (Hilbert) curve. Faces are sorted by (owner, neighbour). Vertices are
    // in the order of their first use in the faces.
    FaceMesh mesh;
    std::vector<Index> original_vertex; // stored vertex -> input vertex; unused vertices are left out
    std::vector<Index> original_cell;   // stored cell -> input cell
    AssembleReport report;
};

// Matches the faces of `input` and sorts cells, vertices and faces. Throws Error when an array has a wrong size or a
// cell type is unknown. A bad cell does not throw; it is left out and counted in `report`. Uses all threads of
// parallel_for.
[[nodiscard]] Assembled assemble(const PolyhedraView& input);

// Appends the faces of one standard cell as loops that are wound outwards. `corners`: vertex ids in VTK's order.
// `face_offset` must begin with 0; it gets the end of each face in face_vertex. Throws Error when `type` is polyhedron,
// or when `corners` has another number of ids than the type has corners.
void append_standard_faces(CellType type, std::span<const Index> corners, std::vector<std::uint64_t>& face_offset,
                           std::vector<Index>& face_vertex);

} // namespace ciel
