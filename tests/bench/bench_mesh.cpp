// bench_mesh KIND EDGE [--shuffle] -o NAME.ciel: writes a generated dataset for benchmarks, with a smooth field, a
// noisy one and a shock, at two times.
#include "ciel/parallel.hpp"
#include "ciel/topology.hpp"
#include "store/writer.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <random>

namespace ciel::test {
using namespace server;
namespace {

constexpr std::size_t bumps = 16;

Polyhedra into_unit_cube(Polyhedra mesh, double edge) {
    for (float& x : mesh.positions) x = static_cast<float>(x / edge);
    return mesh;
}

// Half a tube around the x axis with finer cells inside, similar to grids around launch vehicles.
Polyhedra curvilinear(const std::array<int, 3>& cubes) {
    Polyhedra mesh = hexahedra({cubes});
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
        const double along = mesh.positions[i] / cubes[0];
        const double angle = std::numbers::pi * mesh.positions[i + 1] / cubes[1];
        const double outwards = mesh.positions[i + 2] / cubes[2];
        const double radius = 0.2 + 0.8 * outwards * outwards;
        mesh.positions[i] = static_cast<float>(along);
        mesh.positions[i + 1] = static_cast<float>(radius * std::cos(angle));
        mesh.positions[i + 2] = static_cast<float>(radius * std::sin(angle));
    }
    return mesh;
}

const std::map<std::string, std::function<Polyhedra(int)>>& kinds() {
    static const std::map<std::string, std::function<Polyhedra(int)>> table{
        {"tetrahedra",
         [](int n) {
             return into_unit_cube(tetrahedra({{n, n, n}}), n);
         }},
        {"hexahedra",
         [](int n) {
             return into_unit_cube(hexahedra({{n, n, n}}), n);
         }},
        {"voronoi", [](int n) { return voronoi(n * n * n, 7); }},
        {"prisms", [](int n) { return into_unit_cube(hexagonal_prisms(n, n, n), n); }},
        {"vehicle",
         [](int n) {
             return curvilinear({38 * n, 59 * n, 87 * n});
         }},
    };
    return table;
}

struct Bump {
    Point center;
    double width, height;
};

// Fields over the unit cube. The bumps move with time.
class Fields {
public:
    explicit Fields(double time) {
        std::mt19937_64 random(16);
        std::uniform_real_distribution<double> uniform(0, 1);
        for (std::size_t i = 0; i < bumps; ++i)
            list_.push_back({{uniform(random) + 0.02 * time, uniform(random), uniform(random)},
                             0.05 + 0.1 * uniform(random),
                             0.5 + uniform(random)});
    }
    [[nodiscard]] double smooth(const Point& p) const {
        double sum = p[0];
        for (const Bump& bump : list_) {
            double square = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) square += std::pow(p[axis] - bump.center[axis], 2);
            sum += bump.height * std::exp(-square / (2 * bump.width * bump.width));
        }
        return sum;
    }
    // The field changes mostly within a layer of a few cells.
    [[nodiscard]] static double shock(const Point& p, double time) {
        const double distance = std::hypot(p[0] - 0.3, p[1] - 0.5, p[2] - 0.5);
        return std::tanh((distance - 0.35 - 0.01 * time) / 0.01) + 0.1 * p[0];
    }

private:
    std::vector<Bump> list_;
};

// Pseudo-random, but a function of the position only, whatever the vertex's id.
double noise(const Point& p) {
    const double mixed = std::sin(12.9898 * p[0] * 1e3 + 78.233 * p[1] * 1e3 + 37.719 * p[2] * 1e3) * 43758.5453;
    return mixed - std::floor(mixed);
}

struct Values {
    std::vector<float> smooth, noisy, shock;
};

Values values_at(std::span<const float> positions, double time) {
    const Fields fields(time);
    const std::size_t count = positions.size() / 3;
    Values values{std::vector<float>(count), std::vector<float>(count), std::vector<float>(count)};
    parallel_for(count, 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const Point p{positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]};
            values.smooth[v] = static_cast<float>(fields.smooth(p));
            values.noisy[v] = static_cast<float>(fields.smooth(p) + 0.5 * noise(p));
            values.shock[v] = static_cast<float>(Fields::shock(p, time));
        }
    });
    return values;
}

void write(const Polyhedra& input, bool doubles, const std::string& source, const std::string& output) {
    Assembled assembled = assemble(view(input));
    if (doubles) // stretches the mesh slightly, so that its coordinates need doubles
        for (const float x : assembled.mesh.positions)
            assembled.mesh.double_positions.push_back((1 + 1e-12) * double{x});
    const TopologyCounts counts = Topology(assembled.mesh.view()).counts();
    store::Writer writer(output, {source, "", counts.vertices, counts.edges, counts.cells, {}}, true);
    writer.add_mesh(assembled.mesh, assembled.original_vertex, assembled.original_cell, {});
    for (const double time : {0.0, 1.0}) {
        const Values values = values_at(assembled.mesh.positions, time);
        using store::Association;
        writer.add_step(time, 0, 0,
                        std::vector<store::ArrayValues>{{{"smooth", Association::point, 1, "", ""}, values.smooth},
                                                        {{"noisy", Association::point, 1, "", ""}, values.noisy},
                                                        {{"shock", Association::point, 1, "", ""}, values.shock}});
    }
    writer.finish();
}

} // namespace
} // namespace ciel::test

int main(int argc, char** argv) { // NOLINT(bugprone-exception-escape): an exception may end the program
    using namespace ciel::test;
    CLI::App app{"Writes a generated dataset to measure on.", "bench_mesh"};
    std::string kind, output;
    int edge = 0;
    bool shuffle = false, doubles = false;
    std::vector<std::string> names;
    for (const auto& [name, make] : kinds()) names.push_back(name);
    app.add_option("kind", kind)->required()->check(CLI::IsMember(names));
    app.add_option("edge", edge, "The cube root of how many cells, more or less")
        ->required()
        ->check(CLI::Range(1, 400));
    app.add_flag("--shuffle", shuffle, "Cells in random order in the source");
    app.add_flag("--doubles", doubles, "Positions as float64");
    app.add_option("-o,--output", output, "NAME.ciel")->required();
    CLI11_PARSE(app, argc, argv);
    Polyhedra mesh = kinds().at(kind)(edge);
    if (shuffle) mesh = shuffled(mesh, 3).mesh;
    write(mesh, doubles, kind + " " + std::to_string(edge) + (shuffle ? ", shuffled" : ""), output);
    std::cout << output << ": " << mesh.cell_count() << " cells, " << mesh.vertex_count() << " vertices\n";
    return 0;
}
