// Vertex numbering of the lattice generators. The bits of a cube's corner number are 1 for x, 2 for y, 4 for z.
#pragma once

#include "support/meshes.hpp"

#include <map>
#include <random>

namespace ciel::test {

// Corners of the sides -x +x -y +y -z +z, wound outwards. Each starts at its least corner; the third is the greatest.
inline constexpr int cube_sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

template <typename Visit>
void for_each_cube(std::array<int, 3> cubes, Visit visit) {
    for (int k = 0; k < cubes[2]; ++k) {
        for (int j = 0; j < cubes[1]; ++j) {
            for (int i = 0; i < cubes[0]; ++i) visit(std::array<int, 3>{i, j, k});
        }
    }
}

// Vertex ids of a lattice: lattice points first, with x fastest. Centers of cubes follow in the order of the first
// request.
class LatticePoints {
public:
    LatticePoints(const Box& box, Polyhedra& mesh) : box_(box), mesh_(mesh), random_(box.seed) {
        for_each_cube({box.cubes[0] + 1, box.cubes[1] + 1, box.cubes[2] + 1},
                      [&](std::array<int, 3> p) { add(p[0], p[1], p[2]); });
    }

    [[nodiscard]] Id corner(std::array<int, 3> cube, int bits) const {
        const int i = cube[0] + (bits & 1), j = cube[1] + (bits >> 1 & 1), k = cube[2] + (bits >> 2);
        return static_cast<Id>(i + (box_.cubes[0] + 1) * (j + (box_.cubes[1] + 1) * k));
    }

    [[nodiscard]] Id center(std::array<int, 3> cube) {
        const auto [entry, is_new] = centers_.emplace(cube, 0);
        if (is_new) entry->second = add(cube[0] + 0.5, cube[1] + 0.5, cube[2] + 0.5);
        return entry->second;
    }

private:
    Id add(double x, double y, double z) {
        std::uniform_real_distribution<double> shift(-box_.jitter, box_.jitter);
        Point p{x, y, z};
        for (std::size_t d = 0; d < 3; ++d) {
            const double moved = p[d] + shift(random_);
            if (p[d] > 0 && p[d] < box_.cubes[d]) p[d] = moved; // points on the box's sides stay on them
            p[d] *= box_.edge;
        }
        return mesh_.add_vertex(p);
    }

    Box box_;
    Polyhedra& mesh_;
    std::mt19937_64 random_;
    std::map<std::array<int, 3>, Id> centers_;
};

// Corners may be in any order. The sign of the volume decides the winding, which is outwards.
void add_tetrahedron(Polyhedra& mesh, std::array<Id, 4> corners);

} // namespace ciel::test
