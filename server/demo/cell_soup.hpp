// CellSoup: a list of cells in which neighboring cells do not share points, as a mesh generator returns it.
#pragma once

#include "ciel/assemble.hpp"

namespace server::demo {

struct CellSoup {
    std::vector<ciel::Vec3d> points;
    std::vector<std::uint8_t> cell_types;
    std::vector<std::uint64_t> cell_offset{0};
    std::vector<std::uint64_t> face_offset{0};
    std::vector<ciel::Index> face_point;

    void add(const CellSoup& other);
};

struct WeldedCells {
    std::vector<float> positions;
    std::vector<std::uint8_t> cell_types;
    std::vector<std::uint64_t> cell_offset{0}, face_offset{0};
    std::vector<ciel::Index> face_vertex;

    [[nodiscard]] ciel::PolyhedraView view() const {
        return {{}, positions, cell_types, cell_offset, face_offset, face_vertex};
    }
};

// Merges points whose coordinates differ by at most 1e-9, because voro++ rounds coordinates. Leaves out collapsed edges
// and faces.
[[nodiscard]] WeldedCells weld(const CellSoup& soup);

} // namespace server::demo
