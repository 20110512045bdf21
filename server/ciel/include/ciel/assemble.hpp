// Algorithm 5 of the paper (appendix A), first half: from "vertices + polyhedra as lists of faces as lists of vertex
// indices" to matched faces, in time linear in the input. The second half, per block, is topology.hpp.
#pragma once

#include "ciel/face_mesh.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ciel {

// Borrowed. Faces belong to one cell each (a face between two cells appears twice, once per cell), in any winding.
// Collapsed cells are welcome: vertex ids may repeat in a loop, faces may have collapsed to a line or a point. A cell
// is closed when its half-edges between distinct vertices pair up. A face that lists fewer than three vertices is none:
// the cell is judged by its others.
struct PolyhedraView {
    Vec3d origin{};
    std::span<const float> positions;           // 3 V
    std::span<const std::uint8_t> cell_types;   // C
    std::span<const std::uint64_t> cell_offset; // C + 1, into faces
    std::span<const std::uint64_t> face_offset; // faces + 1, into face_vertex
    std::span<const Index> face_vertex;

    [[nodiscard]] bool is_face(std::uint64_t f) const { return face_offset[f + 1] - face_offset[f] >= 3; }
};

// Cells that cannot be handled are left out and their neighbours' faces become boundary (but for those of a cell that
// is listed twice: they stay with the first).
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
    std::vector<BadCells> bad_cells;       // one entry per reason met
    std::uint64_t reversed_cells = 0;      // wound inwards in the input, turned
    std::uint64_t reversed_faces = 0;      // single faces turned to agree with their cell
    std::uint64_t internal_boundaries = 0; // faces three or more cells claim: left unmatched
    std::uint64_t short_faces = 0;         // with fewer than three vertices, of cells that are kept: left out
    std::vector<Index> first_short;        // at most 10 ids in the input of cells that had them
    // Kept, and wound like their neighbours, although that makes their volume negative (folded curvilinear grids).
    std::uint64_t inverted_cells = 0;
    std::vector<Index> first_inverted; // at most 10, ids in the input
};

struct Assembled {
    FaceMesh mesh;                          // cells in space-filling-curve (Hilbert) order, vertices by first use,
                                            // faces by (owner, neighbour)
    std::vector<Index> original_vertex;     // stored vertex -> input vertex; input vertices no cell uses are dropped
    std::vector<Index> original_cell;       // stored cell -> input cell
    std::vector<std::uint64_t> face_source; // stored face -> input face (of the owner): for naming patches
    AssembleReport report;
};

// Owns all that it returns. Uses all threads of the parallel loop. Throws Error when an array has a wrong size. Bad
// cells never throw; they are reported.
[[nodiscard]] Assembled assemble(const PolyhedraView& input);

// Appends the faces of one standard cell (corners in VTK order) as loops wound outwards. `corners` has the number of
// corners its type has; throws Error for a type that is not standard.
void append_standard_faces(CellType type, std::span<const Index> corners, std::vector<std::uint64_t>& face_offset,
                           std::vector<Index>& face_vertex);

} // namespace ciel
