// Algorithm 5 of the paper (appendix A), first half: from "vertices + polyhedra as lists of faces as lists of vertex
// indices" to matched faces, in time linear in the input. The second half, per block, is topology.hpp.
#pragma once

#include "ciel/face_mesh.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ciel {

// Borrowed. Each face belongs to one cell, in any winding. A face between two cells is listed twice, once per cell.
// Collapsed cells are allowed: a loop may repeat vertex ids, and a face may have collapsed to a line or a point. A cell
// is closed when its half-edges between distinct vertices pair up.
// A face with fewer than three vertices is ignored; the other faces decide whether the cell is usable.
struct PolyhedraView {
    Vec3d origin{};
    std::span<const float> positions;           // 3 V
    std::span<const std::uint8_t> cell_types;   // C
    std::span<const std::uint64_t> cell_offset; // C + 1, into faces
    std::span<const std::uint64_t> face_offset; // faces + 1, into face_vertex
    std::span<const Index> face_vertex;

    [[nodiscard]] bool is_face(std::uint64_t f) const { return face_offset[f + 1] - face_offset[f] >= 3; }
};

// Unusable cells are left out, and the faces of their neighbours become boundary faces. Exception: the neighbours of a
// repeated cell stay matched with the first copy.
struct BadCells {
    enum class Reason {
        open,
        inconsistent_winding,
        inside_out_unresolved,
        index_out_of_range,
        too_few_faces,
        repeated // has the faces of an earlier cell, which is kept
    };
    Reason reason;
    std::uint64_t count = 0;
    std::vector<Index> first_ids; // at most 10, ids in the input
};

struct AssembleReport {
    std::vector<BadCells> bad_cells;       // one entry per reason found
    std::uint64_t reversed_cells = 0;      // wound inwards in the input; all faces reversed
    std::uint64_t reversed_faces = 0;      // single faces reversed to agree with their cell
    std::uint64_t internal_boundaries = 0; // faces of three or more cells: left unmatched
    std::uint64_t short_faces = 0;         // faces of kept cells with fewer than three vertices: left out
    std::vector<Index> first_short;        // cells with such faces: at most 10, ids in the input
    // Kept and wound like their neighbours, which makes their volume negative (folded curvilinear grids).
    std::uint64_t inverted_cells = 0;
    std::vector<Index> first_inverted; // at most 10, ids in the input
};

struct Assembled {
    FaceMesh mesh;                          // cells in space-filling-curve (Hilbert) order, vertices by first use,
                                            // faces by (owner, neighbour)
    std::vector<Index> original_vertex;     // stored vertex -> input vertex; unused input vertices are dropped
    std::vector<Index> original_cell;       // stored cell -> input cell
    std::vector<std::uint64_t> face_source; // stored face -> input face (of the owner): for naming patches
    AssembleReport report;
};

// Returns arrays that own their data. Throws Error when an array has a wrong size or a cell type is unknown. Bad cells
// do not throw; they are reported. Uses all threads of the parallel loop.
[[nodiscard]] Assembled assemble(const PolyhedraView& input);

// Appends the faces of one standard cell (corners in VTK order) as loops wound outwards. Throws Error when `type` is
// not standard or `corners` has another size than the type.
void append_standard_faces(CellType type, std::span<const Index> corners, std::vector<std::uint64_t>& face_offset,
                           std::vector<Index>& face_vertex);

} // namespace ciel
