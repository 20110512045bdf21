#include "support/lattice_points.hpp"
#include "support/meshes.hpp"

#include <cmath>
#include <numbers>
#include <set>

namespace ciel::test {
namespace {

using Cube = std::array<int, 3>;
using Node = std::array<int, 3>; // lattice coordinates in half cube edges

// Cubes of which some are split into eight, on a lattice of half the edge length.
class RefinedCubes {
public:
    RefinedCubes(const Box& box, bool split_faces) : box_(box), split_faces_(split_faces), random_(box.seed) {
        for_each_cube(box.cubes, [&](Cube cube) {
            if (random_() % 4 == 0) refined_.insert(cube);
        });
    }

    Polyhedra make() {
        for_each_cube(box_.cubes, [&](Cube cube) {
            if (!refined_.contains(cube)) return add_coarse(cube);
            for_each_cube({2, 2, 2}, [&](Cube part) {
                std::vector<Loop> loops;
                for (int side = 0; side < 6; ++side) loops.push_back(quad(node(cube, 0, part), side, 1));
                mesh_.add_cell(hexahedron, loops);
            });
        });
        return std::move(mesh_);
    }

private:
    static Node node(Cube cube, int corner, Node extra = {}) {
        return {2 * (cube[0] + (corner & 1)) + extra[0], 2 * (cube[1] + (corner >> 1 & 1)) + extra[1],
                2 * (cube[2] + (corner >> 2)) + extra[2]};
    }

    Id vertex(Node n) {
        const auto [entry, is_new] = vertices_.emplace(n, 0);
        if (is_new) {
            std::uniform_real_distribution<double> shift(-box_.jitter, box_.jitter);
            Point p;
            for (std::size_t d = 0; d < 3; ++d) p[d] = (0.5 * n[d] + shift(random_)) * box_.edge;
            entry->second = mesh_.add_vertex(p);
        }
        return entry->second;
    }

    Loop quad(Node least, int side, int size) {
        Loop loop;
        for (int corner : cube_sides[side]) {
            loop.push_back(vertex({least[0] + size * (corner & 1), least[1] + size * (corner >> 1 & 1),
                                   least[2] + size * (corner >> 2)}));
        }
        return loop;
    }

    // True when a refined cube touches the edge whose midpoint is `middle`.
    bool is_split(Node middle) const {
        for (int corner = 0; corner < 8; ++corner) {
            Cube cube;
            for (int d = 0; d < 3; ++d) cube[d] = (middle[d] - (corner >> d & 1)) >> 1;
            if (refined_.contains(cube)) return true;
        }
        return false;
    }

    void add_coarse(Cube cube) {
        std::vector<Loop> loops;
        for (int side = 0; side < 6; ++side) {
            Cube beyond = cube;
            beyond[side / 2] += side % 2 ? 1 : -1;
            if (split_faces_ && refined_.contains(beyond)) {
                add_quarters(cube, side, loops);
            } else {
                loops.push_back(side_with_middles(cube, side));
            }
        }
        mesh_.add_cell(loops.size() == 6 && corners(loops) == 24 ? hexahedron : polyhedron, loops);
    }

    static std::size_t corners(const std::vector<Loop>& loops) {
        std::size_t sum = 0;
        for (const Loop& loop : loops) sum += loop.size();
        return sum;
    }

    void add_quarters(Cube cube, int side, std::vector<Loop>& loops) {
        for_each_cube({2, 2, 2}, [&](Cube part) {
            if (part[side / 2] == side % 2) loops.push_back(quad(node(cube, 0, part), side, 1));
        });
    }

    Loop side_with_middles(Cube cube, int side) {
        Loop loop;
        for (int i = 0; i < 4; ++i) {
            const Node a = node(cube, cube_sides[side][i]), b = node(cube, cube_sides[side][(i + 1) % 4]);
            const Node middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
            loop.push_back(vertex(a));
            if (split_faces_ && is_split(middle)) loop.push_back(vertex(middle));
        }
        return loop;
    }

    Box box_;
    bool split_faces_;
    std::mt19937_64 random_;
    std::set<Cube> refined_;
    std::map<Node, Id> vertices_;
    Polyhedra mesh_;
};

} // namespace

void add_tetrahedron(Polyhedra& mesh, std::array<Id, 4> corners) {
    const Point o = mesh.position(corners[0]);
    std::array<Point, 3> e;
    for (int i = 0; i < 3; ++i) {
        const Point p = mesh.position(corners[i + 1]);
        for (int d = 0; d < 3; ++d) e[i][d] = p[d] - o[d];
    }
    const double volume = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                          e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                          e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    if (volume < 0) std::swap(corners[2], corners[3]);
    const auto [a, b, c, d] = corners;
    mesh.add_cell(tetrahedron, {{a, b, d}, {b, c, d}, {c, a, d}, {a, c, b}});
}

Polyhedra hanging_nodes(const Box& box) { return RefinedCubes(box, true).make(); }

Polyhedra t_junctions(const Box& box) { return RefinedCubes(box, false).make(); }

Polyhedra o_grid(int rings, int sectors, int layers) {
    Polyhedra mesh;
    std::map<std::array<int, 3>, Id> vertices;
    const auto vertex = [&](int ring, int sector, int layer) {
        const std::array<int, 3> key{ring, ring == 0 ? 0 : sector % sectors, layer};
        const auto [entry, is_new] = vertices.emplace(key, 0);
        const double angle = 2 * std::numbers::pi * key[1] / sectors;
        if (is_new) entry->second = mesh.add_vertex({ring * std::cos(angle), ring * std::sin(angle), double(layer)});
        return entry->second;
    };
    for_each_cube({rings, sectors, layers}, [&](Cube cube) {
        std::vector<Loop> loops;
        for (const auto& side : cube_sides) {
            Loop loop;
            for (int corner : side) {
                loop.push_back(vertex(cube[0] + (corner & 1), cube[1] + (corner >> 1 & 1), cube[2] + (corner >> 2)));
            }
            loops.push_back(loop);
        }
        mesh.add_cell(hexahedron, loops);
    });
    return mesh;
}

Polyhedra giant_cell(int n) {
    Polyhedra mesh;
    std::map<Node, Id> vertices;
    const auto vertex = [&](Node at) {
        const auto [entry, is_new] = vertices.emplace(at, 0);
        if (is_new) entry->second = mesh.add_vertex({double(at[0]), double(at[1]), double(at[2])});
        return entry->second;
    };
    const auto side_of = [&](Cube cube, int side) {
        Loop loop;
        for (int corner : cube_sides[side]) {
            loop.push_back(vertex({cube[0] + (corner & 1), cube[1] + (corner >> 1 & 1), cube[2] + (corner >> 2)}));
        }
        return loop;
    };
    std::vector<Loop> outside;
    for (int side = 0; side < 6; ++side) {
        Cube range{n, n, n};
        range[side / 2] = 1;
        for_each_cube(range, [&](Cube cube) {
            cube[side / 2] = side % 2 ? n - 1 : 0;
            outside.push_back(side_of(cube, side));
        });
    }
    for_each_cube({n, n, 1}, [&](Cube cube) {
        std::vector<Loop> loops;
        for (int side = 0; side < 6; ++side) loops.push_back(side_of({cube[0], cube[1], n}, side));
        mesh.add_cell(hexahedron, loops);
        if (cube[0] == n / 2 && cube[1] == n / 2) mesh.add_cell(polyhedron, outside);
    });
    return mesh;
}

Polyhedra hexagonal_prisms(int columns, int rows, int layers) {
    Polyhedra mesh;
    std::map<std::array<long, 3>, Id> vertices;
    // Vertices lie on a lattice of sqrt(3)/2 x 1/2, so rounded coordinates identify them.
    const double step = std::sqrt(3.0) / 2;
    const auto vertex = [&](double x, double y, int layer) {
        const std::array<long, 3> key{std::lround(x / step), std::lround(2 * y), layer};
        const auto [entry, is_new] = vertices.emplace(key, 0);
        if (is_new) entry->second = mesh.add_vertex({x, y, double(layer)});
        return entry->second;
    };
    for_each_cube({columns, rows, layers}, [&](Cube cube) {
        Loop bottom, top;
        for (int corner = 0; corner < 6; ++corner) {
            const double angle = std::numbers::pi / 6 + corner * std::numbers::pi / 3;
            const double x = 2 * step * (cube[0] + 0.5 * (cube[1] % 2)) + std::cos(angle);
            const double y = 1.5 * cube[1] + std::sin(angle);
            bottom.push_back(vertex(x, y, cube[2]));
            top.push_back(vertex(x, y, cube[2] + 1));
        }
        std::vector<Loop> loops{top, Loop(bottom.rbegin(), bottom.rend())};
        for (std::size_t i = 0; i < 6; ++i) {
            const std::size_t next = (i + 1) % 6;
            loops.push_back({bottom[i], bottom[next], top[next], top[i]});
        }
        mesh.add_cell(polyhedron, loops);
    });
    return mesh;
}

} // namespace ciel::test
