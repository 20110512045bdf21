// Generators of test meshes: every kind of cell and every kind of trouble. All faces are wound outwards; all are
// deterministic in their arguments.
#pragma once

#include "support/polyhedra.hpp"

#include <ostream>
#include <string>

namespace ciel::test {

struct Box {
    std::array<int, 3> cubes;
    double jitter = 0; // of each vertex, in cube edges, but never off the box's sides; inner faces are no longer planar
    std::uint64_t seed = 1;
    double edge = 1; // of a cube
};

// One lattice of cubes, each filled in one of these ways. Where neighbours disagree on how their common side is cut,
// the side is cut into triangles for both, which makes hexahedra and wedges beside it polyhedra.
enum class Fill { whole, six_pyramids, six_tetrahedra, two_wedges };
[[nodiscard]] Polyhedra lattice(const Box& box, const std::function<Fill(std::array<int, 3> cube)>& fill);
[[nodiscard]] Polyhedra hexahedra(const Box& box);
[[nodiscard]] Polyhedra pyramids(const Box& box);
[[nodiscard]] Polyhedra tetrahedra(const Box& box); // six per cube
[[nodiscard]] Polyhedra wedges(const Box& box);
[[nodiscard]] Polyhedra zoo(const Box& box);             // a random fill in each cube
[[nodiscard]] Polyhedra five_tetrahedra(const Box& box); // per cube, in alternating orientation
[[nodiscard]] Polyhedra collapsed_edges(const Box& box); // hexahedra, some of whose edges have shrunk to a point
[[nodiscard]] Polyhedra
hanging_nodes(const Box& box); // random cubes in eight; their neighbours are polyhedra with split faces
[[nodiscard]] Polyhedra t_junctions(const Box& box); // as above, but the neighbours' faces stay whole and do not match
[[nodiscard]] Polyhedra o_grid(int rings, int sectors,
                               int layers); // hexahedra around an axis; the innermost are collapsed
[[nodiscard]] Polyhedra hexagonal_prisms(int columns, int rows, int layers);
// One cell with n x n quads on each of its six sides, and a layer of n x n hexahedra on top.
[[nodiscard]] Polyhedra giant_cell(int n);
[[nodiscard]] Polyhedra voronoi(int cells, std::uint64_t seed); // of random points in the unit cube

struct NamedMesh {
    std::string name;
    Polyhedra (*make)();
    bool planar_faces = true;      // up to rounding
    bool has_repeated_ids = false; // loops with a vertex twice

    friend std::ostream& operator<<(std::ostream& out, const NamedMesh& mesh) { return out << mesh.name; }
};

// Small ones of all of the above, and meshes with voids, several components, edges and vertices where only two cells
// touch, agglomerates, one cell, no cell.
[[nodiscard]] const std::vector<NamedMesh>& all_meshes();

} // namespace ciel::test
