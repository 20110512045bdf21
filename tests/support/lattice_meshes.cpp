#include "support/lattice_points.hpp"
#include "support/meshes.hpp"

#include <algorithm>
#include <random>

namespace ciel::test {
namespace {

using Cube = std::array<int, 3>;

class LatticeMesh {
public:
    LatticeMesh(const Box& box, const std::function<Fill(Cube)>& fill) : box_(box), fill_(fill), points_(box, mesh_) {}

    Polyhedra make() {
        for_each_cube(box_.cubes, [&](Cube cube) {
            switch (fill_(cube)) {
            case Fill::whole:
                add_hexahedron(cube);
                break;
            case Fill::six_pyramids:
                add_pyramids(cube);
                break;
            case Fill::six_tetrahedra:
                add_tetrahedra(cube);
                break;
            case Fill::two_wedges:
                add_wedges(cube);
                break;
            }
        });
        return std::move(mesh_);
    }

private:
    // True when this cube's filling splits the side into triangles, along the diagonal from its least to its greatest
    // corner.
    bool cuts(Cube cube, int side) const {
        const Fill fill = fill_(cube);
        return fill == Fill::six_tetrahedra || (fill == Fill::two_wedges && side >= 4);
    }

    std::vector<Loop> side_loops(Cube cube, int side) {
        Loop quad;
        for (int corner : cube_sides[side]) quad.push_back(points_.corner(cube, corner));
        Cube beyond = cube;
        beyond[side / 2] += side % 2 ? 1 : -1;
        const bool inside = beyond[side / 2] >= 0 && beyond[side / 2] < box_.cubes[side / 2];
        if (!cuts(cube, side) && !(inside && cuts(beyond, side ^ 1))) return {quad};
        return {{quad[0], quad[1], quad[2]}, {quad[0], quad[2], quad[3]}};
    }

    void add_sides(Cube cube, std::initializer_list<int> sides, std::vector<Loop>& loops) {
        for (int side : sides) {
            for (Loop& loop : side_loops(cube, side)) loops.push_back(std::move(loop));
        }
    }

    void add_hexahedron(Cube cube) {
        std::vector<Loop> loops;
        add_sides(cube, {0, 1, 2, 3, 4, 5}, loops);
        mesh_.add_cell(loops.size() == 6 ? hexahedron : polyhedron, loops);
    }

    void add_pyramids(Cube cube) {
        const Id center = points_.center(cube);
        std::vector<Loop> bases;
        add_sides(cube, {0, 1, 2, 3, 4, 5}, bases);
        for (const Loop& base : bases) {
            std::vector<Loop> loops{base};
            for (std::size_t i = 0; i < base.size(); ++i)
                loops.push_back({base[(i + 1) % base.size()], base[i], center});
            mesh_.add_cell(base.size() == 4 ? pyramid : tetrahedron, loops);
        }
    }

    void add_tetrahedra(Cube cube) {
        std::array<int, 3> axes{0, 1, 2};
        do {
            const int second = 1 << axes[0], third = second | 1 << axes[1];
            add_tetrahedron(mesh_, {points_.corner(cube, 0), points_.corner(cube, second), points_.corner(cube, third),
                                    points_.corner(cube, 7)});
        } while (std::next_permutation(axes.begin(), axes.end()));
    }

    void add_wedges(Cube cube) {
        const auto v = [&](int corner) { return points_.corner(cube, corner); };
        std::vector<Loop> right{{v(0), v(3), v(1)}, {v(4), v(5), v(7)}, {v(3), v(0), v(4), v(7)}};
        add_sides(cube, {1, 2}, right);
        mesh_.add_cell(right.size() == 5 ? wedge : polyhedron, right);
        std::vector<Loop> left{{v(0), v(2), v(3)}, {v(4), v(7), v(6)}, {v(0), v(3), v(7), v(4)}};
        add_sides(cube, {0, 3}, left);
        mesh_.add_cell(left.size() == 5 ? wedge : polyhedron, left);
    }

    Box box_;
    const std::function<Fill(Cube)>& fill_;
    Polyhedra mesh_;
    LatticePoints points_;
};

} // namespace

Polyhedra lattice(const Box& box, const std::function<Fill(Cube)>& fill) { return LatticeMesh(box, fill).make(); }

Polyhedra hexahedra(const Box& box) {
    return lattice(box, [](Cube) { return Fill::whole; });
}
Polyhedra pyramids(const Box& box) {
    return lattice(box, [](Cube) { return Fill::six_pyramids; });
}
Polyhedra tetrahedra(const Box& box) {
    return lattice(box, [](Cube) { return Fill::six_tetrahedra; });
}
Polyhedra wedges(const Box& box) {
    return lattice(box, [](Cube) { return Fill::two_wedges; });
}

Polyhedra zoo(const Box& box) {
    return lattice(box, [&](Cube cube) {
        std::seed_seq seeds{static_cast<int>(box.seed), cube[0], cube[1], cube[2]};
        return static_cast<Fill>(std::mt19937(seeds)() % 4);
    });
}

Polyhedra five_tetrahedra(const Box& box) {
    Polyhedra mesh;
    LatticePoints points(box, mesh);
    for_each_cube(box.cubes, [&](Cube cube) {
        // Every second cube is mirrored along x, so that the diagonals of neighbors agree.
        const int odd = (cube[0] + cube[1] + cube[2]) % 2;
        const auto v = [&](int corner) { return points.corner(cube, corner ^ odd); };
        add_tetrahedron(mesh, {v(0), v(3), v(5), v(6)});
        for (int corner : {1, 2, 4, 7}) add_tetrahedron(mesh, {v(corner), v(corner ^ 1), v(corner ^ 2), v(corner ^ 4)});
    });
    return mesh;
}

Polyhedra collapsed_edges(const Box& box) {
    Polyhedra mesh = hexahedra(box);
    const auto [nx, ny, nz] = box.cubes;
    std::mt19937_64 random(box.seed);
    std::vector<Id> replacement(mesh.vertex_count());
    for (int k = 0, v = 0; k <= nz; ++k) {
        for (int j = 0; j <= ny; ++j) {
            for (int i = 0; i <= nx; ++i, ++v) {
                // Collapses at most every third edge along x, in a diagonal pattern, so that no cell collapses
                // entirely.
                const bool collapses = i < nx && (i + j + k) % 3 == 0 && random() % 2 == 0;
                replacement[static_cast<Id>(v)] = static_cast<Id>(collapses ? v + 1 : v);
            }
        }
    }
    for (Id& v : mesh.face_vertex) v = replacement[v];
    return mesh;
}

} // namespace ciel::test
