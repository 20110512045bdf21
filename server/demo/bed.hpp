// The demo's geometry: a cylinder of radius 1 along z in a box, on a lattice. Around the cylinder and in the near wake
// the spacing is equal and Voronoi cells replace the lattice's. Outwards it widens and the cells are hexahedra.
#pragma once

#include "demo/cell_soup.hpp"

namespace ciel::demo {

struct Bed {
    // Cells `coarseness` times as long, in a box of almost the same size.
    explicit Bed(int coarseness = 1);

    double spacing;
    std::vector<double> x, y, z;                // the planes of the lattice
    std::size_t x_begin, x_end, y_begin, y_end; // planes that bound the Voronoi cells

    [[nodiscard]] bool is_voronoi(std::size_t i, std::size_t j) const {
        return i >= x_begin && i < x_end && j >= y_begin && j < y_end;
    }
};

[[nodiscard]] CellSoup hexahedra(const Bed& bed);

// Computes the cells with voro++. The seeds are the lattice's cell centres, moved at random. Those of the outermost
// layer are not moved, so that its cells keep exactly the lattice's faces towards the hexahedra. A ring of seeds around
// the cylinder has mirror images inside it. The flat faces between seeds and images are the wall: a prism whose edges
// lie on the cylinder.
[[nodiscard]] CellSoup voronoi_cells(const Bed& bed);

} // namespace ciel::demo
