// First half of the paper's Algorithm 5 (appendix A): matches the faces of polyhedra that are given as lists of faces.
// Takes time linear in the input. The second half, which builds the half-edges of each block, is in topology.hpp.
#pragma once

#include "ciel/face_mesh.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ciel {

// Cells as lists of faces, faces as loops of vertex ids. V vertices, C cells. Does not own its arrays.
// Each face belongs to one cell, in any winding. A face between two cells is listed twice, once per cell.
// Collapsed cells are allowed: a loop may repeat vertex ids, and a face may have collapsed to a line or a point. A cell
// is closed when its half-edges between distinct vertices pair up.
// A face with fewer than three vertices is ignored; the other faces decide whether the cell is usable.
struct PolyhedraView {
    Vec3d origin{};
    ValuesView positions;                       // 3 V: offsets from origin
    std::span<const std::uint8_t> cell_types;   // C: CellType
    std::span<const std::uint64_t> cell_offset; // C + 1: cell c has the faces cell_offset[c] to cell_offset[c + 1] - 1
    std::span<const std::uint64_t> face_offset; // one per face and one more: first entry in face_vertex
    std::span<const Index> face_vertex;

    [[nodiscard]] bool is_face(std::uint64_t f) const { return face_offset[f + 1] - face_offset[f] >= 3; }
};

// Cells that assemble() left out for one reason. Faces that they shared with other cells become boundary faces.
// Exception: the neighbors of a repeated cell stay matched with the first copy.
struct BadCells {
    enum class Reason {
        open,
        inconsistent_winding,
        inside_out_unresolved,
        index_out_of_range,
        too_few_faces,
        repeated // has the same faces as an earlier cell; the earlier cell is kept
    };
    Reason reason;
    std::uint64_t count = 0;
    std::vector<Index> first_ids; // input ids of the first 10 of these cells, or fewer
};

struct AssembleReport {
    std::vector<BadCells> bad_cells;  // one entry per reason found
    std::uint64_t reversed_cells = 0; // wound inwards in the input; all their faces are reversed
    std::uint64_t reversed_faces = 0; // single faces reversed to agree with the other faces of their cell
    // Faces left unmatched: those of three or more cells, and those whose two cells cannot be wound alike.
    std::uint64_t internal_boundaries = 0;
    std::uint64_t short_faces = 0;  // faces with fewer than three vertices, left out of cells that are kept
    std::vector<Index> first_short; // input ids of the first 10 cells with short faces, or fewer
    // Cells that are wound like their neighbors although their volume is then negative (folded curvilinear grids).
    // They are kept.
    std::uint64_t inverted_cells = 0;
    std::vector<Index> first_inverted; // input ids of the first 10 inverted cells, or fewer
};

struct Assembled {
    // Cells are in space-filling-curve (Hilbert) order, faces by (owner, neighbour), vertices by first use.
    FaceMesh mesh;
    std::vector<Index> original_vertex;     // stored vertex -> input vertex; unused input vertices are dropped
    std::vector<Index> original_cell;       // stored cell -> input cell
    std::vector<std::uint64_t> face_source; // stored face -> the owner's face in the input
    AssembleReport report;
};

// Matches the faces of `input` and sorts cells, vertices and faces. Throws Error when an array has a wrong size or a
// cell type is unknown. Bad cells do not throw; AssembleReport counts them. Uses all threads of the parallel loop.
[[nodiscard]] Assembled assemble(const PolyhedraView& input);

// Appends the faces of one standard cell as loops wound outwards. `corners` are vertex ids in VTK order. Throws Error
// when `type` is polyhedron or `corners` does not have as many ids as the type has corners.
void append_standard_faces(CellType type, std::span<const Index> corners, std::vector<std::uint64_t>& face_offset,
                           std::vector<Index>& face_vertex);

} // namespace ciel
