// Small meshes for tests of the kernel.
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
Polyhedra tetrahedra(Index nx, Index ny, Index nz);       // six per unit cell, conforming
Polyhedra hexagonal_prisms(Index nx, Index ny, Index nz); // honeycomb of polyhedra
Polyhedra hanging_nodes();                                // one large cube with 9 faces beside four small cubes
Polyhedra mixed_cells();                                  // one hexahedron, wedge, pyramid, tetrahedron and polyhedron
Polyhedra collapsed_hexahedra(Index sectors); // O-grid around an axis; the faces at the axis collapse to lines
Polyhedra cubes_that_share_an_edge();
Polyhedra hollow_box(); // 26 cubes around an empty one
// Cells with a part of the boundary that can be turned separately. pinched_cell: one cell of two cubes that touch along
// an edge, between two cubes. cell_around_a_cell: a box with a cubic cell inside.
Polyhedra pinched_cell();
Polyhedra cell_around_a_cell();

struct NamedMesh {
    std::string name;
    FaceMesh mesh;
};
std::vector<NamedMesh> all_meshes(); // one of each mesh declared here, and one without cells

} // namespace ciel::test
