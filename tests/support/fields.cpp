#include "support/fields.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace ciel::test {

std::vector<float> random_field(std::size_t vertices, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<float> values(vertices);
    for (float& value : values) value = uniform(random);
    return values;
}

std::vector<float> tied_field(std::size_t vertices, int levels, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> uniform(0, levels - 1);
    std::vector<float> values(vertices);
    for (float& value : values) value = static_cast<float>(uniform(random));
    return values;
}

std::vector<float> linear_field(const Polyhedra& mesh, const LinearField& field) {
    std::vector<float> values;
    for (Id v = 0; v < mesh.vertex_count(); ++v) values.push_back(static_cast<float>(field.at(mesh.position(v))));
    return values;
}

std::vector<float> bumps_field(const Polyhedra& mesh, std::uint64_t seed) {
    Point low{}, high{};
    for (Id v = 0; v < mesh.vertex_count(); ++v) {
        for (int d = 0; d < 3; ++d) {
            low[d] = v == 0 ? mesh.position(v)[d] : std::min(low[d], mesh.position(v)[d]);
            high[d] = v == 0 ? mesh.position(v)[d] : std::max(high[d], mesh.position(v)[d]);
        }
    }
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::array<Point, 5> centers;
    for (Point& center : centers) {
        for (double& coordinate : center) coordinate = uniform(random);
    }
    std::vector<float> values;
    for (Id v = 0; v < mesh.vertex_count(); ++v) {
        double sum = 0;
        for (const Point& center : centers) {
            double square = 0;
            for (int d = 0; d < 3; ++d) {
                square += std::pow((mesh.position(v)[d] - low[d]) / std::max(high[d] - low[d], 1e-30) - center[d], 2);
            }
            sum += std::exp(-square / 0.08);
        }
        values.push_back(static_cast<float>(sum));
    }
    return values;
}

std::vector<float> plateau_field(const Polyhedra& mesh, std::uint64_t seed) {
    std::vector<float> values = bumps_field(mesh, seed);
    for (float& value : values) value = std::clamp(value, 0.25F, 0.5F);
    return values;
}

const std::vector<NamedField>& all_fields() {
    static const std::vector<NamedField> fields{
        {"random", [](const Polyhedra& mesh) { return random_field(mesh.vertex_count(), 31); }},
        {"constant", [](const Polyhedra& mesh) { return std::vector<float>(mesh.vertex_count(), 2.5F); }},
        {"plateau", [](const Polyhedra& mesh) { return plateau_field(mesh, 32); }},
        {"tied", [](const Polyhedra& mesh) { return tied_field(mesh.vertex_count(), 4, 33); }},
        {"two_valued", [](const Polyhedra& mesh) { return tied_field(mesh.vertex_count(), 2, 34); }},
        {"linear",
         [](const Polyhedra& mesh) {
             return linear_field(mesh, {{1, 0.5, -0.25}, 0.125});
         }},
        {"along_x",
         [](const Polyhedra& mesh) {
             return linear_field(mesh, {{1, 0, 0}, 0});
         }},
        {"bumps", [](const Polyhedra& mesh) { return bumps_field(mesh, 35); }},
    };
    return fields;
}

std::vector<double> walk_through(const std::vector<float>& values, int steps, std::uint64_t seed) {
    if (values.empty()) return {-1, 0, 1};
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    const double low = *least, high = *greatest, span = std::max(high - low, 1e-3);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<double> walk{low - span, low, high, std::nextafter(high, high + 1), high + span};
    double nu = low + 0.5 * span;
    for (int step = 0; step < steps; ++step) {
        switch (random() % 6) {
        case 0:
        case 1:
            nu += 0.04 * span * uniform(random);
            break;
        case 2:
        case 3:
            nu -= 0.04 * span * uniform(random);
            break;
        case 4:
            nu = low + span * uniform(random);
            break;
        default:
            nu = values[random() % values.size()];
            break;
        }
        walk.push_back(nu);
        if (step % 7 == 3) walk.push_back(nu);
    }
    return walk;
}

} // namespace ciel::test
