// The demo's geometry: a box with a cylinder of radius 1 along z, divided by a lattice. Voronoi cells replace the cells
// of the lattice around the cylinder and in the near wake. Further out, the cells are hexahedra.
#pragma once

#include "demo/cell_soup.hpp"

namespace server::demo {

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

// The seeds are the centers of lattice cells, moved at random, except in the outermost layer, whose outer faces the
// hexahedra share. Each seed of a ring around the cylinder has a mirror image inside the cylinder. The flat faces
// between these seeds and their images form the wall.
[[nodiscard]] CellSoup voronoi_cells(const Bed& bed);

} // namespace server::demo
