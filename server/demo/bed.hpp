// The demo's geometry: a cylinder of radius 1 along z in a box. A lattice with equal spacing around the cylinder and in
// the near wake, where its cells are replaced by Voronoi cells, and widening outwards, where they stay hexahedra.
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

// Seeds: the lattice's cell centres, moved at random but for the outermost layer, whose cells keep the lattice's faces
// towards the hexahedra exactly; and a ring around the cylinder with a mirror image inside it, so that the wall is the
// flat faces between seeds and images: a prism whose edges lie on the cylinder. Cells are computed by voro++.
[[nodiscard]] CellSoup voronoi_cells(const Bed& bed);

} // namespace ciel::demo
