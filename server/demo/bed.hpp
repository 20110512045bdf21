// The demo's geometry: a box with a cylinder of radius 1 along z, divided by a lattice. Around the cylinder and in the
// near wake, the lattice has a constant spacing, and Voronoi cells replace the cells of the lattice. Further out, the
// spacing grows, and the cells are hexahedra.
#pragma once

#include "demo/cell_soup.hpp"

namespace ciel::demo {

struct Bed {
    // coarseness: factor on the length of cells. The size of the box hardly depends on the coarseness.
    explicit Bed(int coarseness = 1);

    double spacing;                             // distance between the lattice planes among the Voronoi cells
    std::vector<double> x, y, z;                // coordinates of the lattice's planes, ascending
    std::size_t x_begin, x_end, y_begin, y_end; // indices of the planes that bound the Voronoi cells

    [[nodiscard]] bool is_voronoi(std::size_t i, std::size_t j) const {
        return i >= x_begin && i < x_end && j >= y_begin && j < y_end;
    }
};

[[nodiscard]] CellSoup hexahedra(const Bed& bed);

// Computes the Voronoi cells with voro++. The seeds are the centers of lattice cells, moved at random. Seeds of the
// outermost layer are not moved. Therefore the outer faces of this layer are faces of the lattice, which the hexahedra
// share. A ring of seeds around the cylinder has mirror images inside the cylinder. The flat faces between these seeds
// and their images form the wall: a prism whose edges lie on the cylinder.
[[nodiscard]] CellSoup voronoi_cells(const Bed& bed);

} // namespace ciel::demo
