// The faces of consecutive cells, with mesh-wide numbers: the input of Algorithm 5 (paper, appendix A) for one block.
#pragma once

#include "ciel/types.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace ciel::detail {

// The faces of the mesh have numbers in the order of (owner, other cell). Each face has one loop, wound outwards from
// its owner. A loop may repeat vertices (collapsed cells).
struct FaceLoops {
    std::vector<Index> mesh_face;                // loop -> mesh face; faces that the cells own come first, ascending
    std::vector<std::array<Index, 2>> mesh_cell; // loop -> mesh cells: owner, and neighbor or none
    std::vector<Index> begin;                    // loop -> first corner; the last entry is the number of corners
    std::vector<Index> vertex;                   // by corner: mesh vertex
    // cell_loop: 2 * loop + side, cell by cell, and in the order of mesh faces in each cell. Side 0 is the owner's,
    // side 1 the neighbor's. cell_loop_begin: index in cell_loop of each cell's first face; the last entry is the size
    // of cell_loop.
    std::vector<Index> cell_loop_begin, cell_loop;

    [[nodiscard]] Index loop_count() const { return static_cast<Index>(mesh_face.size()); }
};

// Thread-safe.
class FaceSource {
public:
    FaceSource() = default;
    FaceSource(const FaceSource&) = delete;
    FaceSource& operator=(const FaceSource&) = delete;
    virtual ~FaceSource() = default;

    [[nodiscard]] virtual Index vertex_count() const = 0;
    // Sets `out` to the faces of the cells [cell_begin, cell_end). Throws Error when the data contradict each other.
    virtual void list(Index cell_begin, Index cell_end, FaceLoops& out) const = 0;
    // Throws Error for data that contradict each other.
    [[noreturn]] virtual void refuse() const = 0;
};

} // namespace ciel::detail
