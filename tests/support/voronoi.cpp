#include "support/meshes.hpp"

#include <voro++/voro++.hh>

#include <cmath>
#include <map>
#include <random>

namespace ciel::test {
namespace {

// Merges vertices of neighboring cells. voro++ computes each cell alone, so their rounding differs.
class Welder {
public:
    explicit Welder(Polyhedra& mesh) : mesh_(mesh) {}

    Id vertex(Point p) {
        for (double& x : p) { // the box's sides are exact
            if (std::abs(x - std::round(x)) < tolerance) x = std::round(x);
        }
        std::array<long, 3> home;
        for (int d = 0; d < 3; ++d) home[d] = std::lround(p[d] / tolerance);
        for (int i = 0; i < 27; ++i) {
            const auto found = vertices_.find({home[0] + i % 3 - 1, home[1] + i / 3 % 3 - 1, home[2] + i / 9 - 1});
            if (found != vertices_.end()) return found->second;
        }
        return vertices_[home] = mesh_.add_vertex(p);
    }

private:
    static constexpr double tolerance = 1e-8;
    Polyhedra& mesh_;
    std::map<std::array<long, 3>, Id> vertices_;
};

} // namespace

Polyhedra voronoi(int cells, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    const int grid = std::max(1, static_cast<int>(std::cbrt(cells / 6.0)));
    voro::container container(0, 1, 0, 1, 0, 1, grid, grid, grid, false, false, false, 8);
    for (int i = 0; i < cells; ++i) {
        const double x = uniform(random), y = uniform(random), z = uniform(random);
        container.put(i, x, y, z);
    }

    Polyhedra mesh;
    Welder welder(mesh);
    voro::c_loop_all loop(container);
    voro::voronoicell cell;
    if (!loop.start()) return mesh;
    do {
        if (!container.compute_cell(cell, loop)) continue;
        double x, y, z;
        loop.pos(x, y, z);
        std::vector<double> corners;
        std::vector<int> faces; // for each face: its number of corners, then their ids
        cell.vertices(x, y, z, corners);
        cell.face_vertices(faces);
        std::vector<Loop> loops;
        for (std::size_t i = 0; i < faces.size(); i += static_cast<std::size_t>(faces[i]) + 1) {
            Loop face;
            for (int j = 1; j <= faces[i]; ++j) {
                const auto corner = static_cast<std::size_t>(3 * faces[i + static_cast<std::size_t>(j)]);
                const Id v = welder.vertex({corners[corner], corners[corner + 1], corners[corner + 2]});
                if (face.empty() || face.back() != v) face.push_back(v);
            }
            if (face.size() > 1 && face.front() == face.back()) face.pop_back();
            if (face.size() >= 3) loops.emplace_back(face.rbegin(), face.rend()); // voro++ winds faces inwards
        }
        mesh.add_cell(polyhedron, loops);
    } while (loop.inc());
    return mesh;
}

} // namespace ciel::test
