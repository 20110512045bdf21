// Small meshes that are written down by hand or grown from a grid.
#pragma once

#include "ciel/assemble.hpp"

#include <initializer_list>
#include <string>

namespace ciel::test {

class Polyhedra {
public:
    Index vertex(double x, double y, double z);
    void cell(CellType type, const std::vector<Index>& corners);
    void polyhedron(const std::vector<std::vector<Index>>& faces);
    [[nodiscard]] PolyhedraView view() const;
    [[nodiscard]] Assembled assembled() const { return assemble(view()); }

    std::vector<float> positions;
    std::vector<std::uint8_t> types;
    std::vector<std::uint64_t> cell_offset{0}, face_offset{0};
    std::vector<Index> face_vertex;
};

Polyhedra one_tetrahedron();
Polyhedra hexahedra(Index nx, Index ny, Index nz);        // unit cells
Polyhedra tetrahedra(Index nx, Index ny, Index nz);       // six to a unit cell, conforming
Polyhedra hexagonal_prisms(Index nx, Index ny, Index nz); // a honeycomb, as polyhedra
Polyhedra hanging_nodes();                                // one big cube of 9 faces beside four small ones
Polyhedra mixed_cells();                                  // hexahedron, wedge, pyramid, tetrahedron and a polyhedron
Polyhedra collapsed_hexahedra(Index sectors); // an O-grid around an axis: the inner faces collapse to a line
Polyhedra cubes_that_share_an_edge();
Polyhedra hollow_box(); // 26 cubes around a void
// Cells in whose boundary a part can be turned by itself: two cubes that touch along an edge as one cell between two
// cubes, and a box around a cube that is a cell of its own.
Polyhedra pinched_cell();
Polyhedra cell_around_a_cell();

struct NamedMesh {
    std::string name;
    FaceMesh mesh;
};
std::vector<NamedMesh> all_meshes(); // one of each of the above, and one without cells

} // namespace ciel::test
