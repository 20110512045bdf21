// Cells with corners of their own, as they come out of a generator; welding makes a mesh of them.
#pragma once

#include "ciel/assemble.hpp"

namespace ciel::demo {

struct CellSoup {
    std::vector<Vec3d> points;
    std::vector<std::uint8_t> cell_types;
    std::vector<std::uint64_t> cell_offset{0};
    std::vector<std::uint64_t> face_offset{0};
    std::vector<Index> face_point;

    void add(const CellSoup& other);
};

struct WeldedCells {
    std::vector<float> positions;
    std::vector<std::uint8_t> cell_types;
    std::vector<std::uint64_t> cell_offset{0}, face_offset{0};
    std::vector<Index> face_vertex;

    [[nodiscard]] PolyhedraView view() const {
        return {{}, positions, cell_types, cell_offset, face_offset, face_vertex};
    }
};

// Points closer than the rounding of voro++ (and far closer than any two corners that differ) become one vertex. Edges
// and faces that vanish by it are left out.
[[nodiscard]] WeldedCells weld(const CellSoup& soup);

} // namespace ciel::demo
