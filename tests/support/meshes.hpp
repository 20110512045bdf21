// Generators of test meshes with all kinds of cells and defects. Faces are wound outwards. Equal arguments give equal
// meshes.
#pragma once

#include "support/polyhedra.hpp"

#include <ostream>
#include <string>

namespace ciel::test {

struct Box {
    std::array<int, 3> cubes;
    // Random shift of each vertex, in cube edges. Vertices stay on the box's sides. Inner faces become nonplanar.
    double jitter = 0;
    std::uint64_t seed = 1;
    double edge = 1; // length of a cube's edge
};

// A lattice of cubes, each filled as `fill` returns. When neighbors would split their common side differently, both get
// triangles there. Hexahedra and wedges beside such a side become polyhedra.
enum class Fill { whole, six_pyramids, six_tetrahedra, two_wedges };
[[nodiscard]] Polyhedra lattice(const Box& box, const std::function<Fill(std::array<int, 3> cube)>& fill);
[[nodiscard]] Polyhedra hexahedra(const Box& box);
[[nodiscard]] Polyhedra pyramids(const Box& box);
[[nodiscard]] Polyhedra tetrahedra(const Box& box); // six tetrahedra per cube
[[nodiscard]] Polyhedra wedges(const Box& box);
[[nodiscard]] Polyhedra zoo(const Box& box);             // a random Fill in each cube
[[nodiscard]] Polyhedra five_tetrahedra(const Box& box); // five tetrahedra per cube, mirrored in every second
[[nodiscard]] Polyhedra collapsed_edges(const Box& box); // hexahedra with some edges collapsed to a point
// Random cubes are split into eight. Their neighbors become polyhedra with split faces.
[[nodiscard]] Polyhedra hanging_nodes(const Box& box);
// Like hanging_nodes, but the neighbors' faces stay whole and do not match.
[[nodiscard]] Polyhedra t_junctions(const Box& box);
// Hexahedra around an axis. The innermost are collapsed.
[[nodiscard]] Polyhedra o_grid(int rings, int sectors, int layers);
[[nodiscard]] Polyhedra hexagonal_prisms(int columns, int rows, int layers);
// One cell with n x n quadrilaterals on each of its six sides, and a layer of n x n hexahedra on top.
[[nodiscard]] Polyhedra giant_cell(int n);
[[nodiscard]] Polyhedra voronoi(int cells, std::uint64_t seed); // Voronoi cells of random points in the unit cube

struct NamedMesh {
    std::string name;
    Polyhedra (*make)();
    bool planar_faces = true;      // planar up to rounding
    bool has_repeated_ids = false; // some loops contain a vertex twice

    friend std::ostream& operator<<(std::ostream& out, const NamedMesh& mesh) { return out << mesh.name; }
};

// Small meshes of all generators, and special ones: voids, several components, edges and vertices where only two cells
// touch, agglomerated cells, one cell, no cell.
[[nodiscard]] const std::vector<NamedMesh>& all_meshes();

} // namespace ciel::test
