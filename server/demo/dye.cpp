#include "demo/dye.hpp"

#include "ciel/parallel.hpp"
#include "demo/flow.hpp"

#include <algorithm>
#include <cmath>

namespace server::demo {
namespace {

constexpr double spacing = 0.08;
constexpr std::size_t phases = 40;
constexpr std::size_t periods = 6; // number of periods to compute, after which the dye is periodic
// The source has full strength up to the first radius, and zero strength from the second radius on.
constexpr double source_inside = 1.25, source_outside = 1.9;
// In each pass, in squared spacings. Widens filaments that are too thin for the mesh. A larger number is unstable.
constexpr float diffusion = 0.24F;
constexpr int diffusions = 4;
constexpr std::size_t nodes_per_task = 2048;

double source(double x, double y) {
    return std::clamp((source_outside - std::hypot(x, y)) / (source_outside - source_inside), 0.0, 1.0);
}

// Catmull-Rom weights of four equidistant nodes. t: 0 at the second node, 1 at the third node.
std::array<double, 4> cubic(double t) {
    return {((-t + 2) * t - 1) * t / 2, ((3 * t - 5) * t * t + 2) / 2, ((-3 * t + 4) * t + 1) * t / 2,
            (t - 1) * t * t / 2};
}

} // namespace

Dye::Dye(Extent extent)
    : extent_(extent), nx_(static_cast<std::size_t>((extent.x_high - extent.x_low) / spacing) + 2),
      ny_(static_cast<std::size_t>((extent.y_high - extent.y_low) / spacing) + 2) {
    const std::size_t nodes = nx_ * ny_;
    constexpr double dt = 1.0 / phases;
    std::vector<std::vector<std::array<float, 2>>> departures(phases);
    ciel::parallel_for(phases, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t phase = begin; phase < end; ++phase) {
            const Flow after(static_cast<double>(phase + 1) * dt), between((static_cast<double>(phase) + 0.5) * dt);
            departures[phase].resize(nodes);
            for (std::size_t i = 0; i < nodes; ++i) {
                const auto [x, y] = node(i);
                const FlowSample here = after.at(x, y);
                const FlowSample middle = between.at(x - 0.5 * dt * here.u, y - 0.5 * dt * here.v);
                departures[phase][i] = {static_cast<float>(x - dt * middle.u), static_cast<float>(y - dt * middle.v)};
            }
        }
    });
    planes_.assign(phases, std::vector<float>(nodes, 0.0F));
    for (std::size_t s = 0; s < periods * phases; ++s)
        step(departures[s % phases], planes_[s % phases], planes_[(s + 1) % phases]);
}

std::array<float, 2> Dye::node(std::size_t index) const {
    const std::size_t column = index % nx_;
    const std::size_t row = index / nx_;
    return {static_cast<float>(extent_.x_low + static_cast<double>(column) * spacing),
            static_cast<float>(extent_.y_low + static_cast<double>(row) * spacing)};
}

void Dye::step(const std::vector<std::array<float, 2>>& departure, const std::vector<float>& from,
               std::vector<float>& to) const {
    std::vector<float> carried(from.size());
    ciel::parallel_for(from.size(), nodes_per_task, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto [x, y] = node(i);
            carried[i] = std::max(static_cast<float>(source(x, y)), sample(from, departure[i][0], departure[i][1]));
        }
    });
    for (int pass = 0; pass < diffusions; ++pass) {
        spread(carried, to);
        carried.swap(to);
    }
    carried.swap(to);
}

void Dye::spread(const std::vector<float>& from, std::vector<float>& to) const {
    ciel::parallel_for(from.size(), nodes_per_task, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::size_t column = i % nx_;
            const bool rim = column == 0 || column + 1 == nx_ || i < nx_ || i + nx_ >= from.size();
            const float around = rim ? 4 * from[i] : from[i - 1] + from[i + 1] + from[i - nx_] + from[i + nx_];
            to[i] = from[i] + diffusion * (around - 4 * from[i]);
        }
    });
}

float Dye::sample(const std::vector<float>& plane, double x, double y) const {
    if (x < extent_.x_low || y < extent_.y_low || y > extent_.y_high) return 0; // inflow without dye
    const double gx = std::min((x - extent_.x_low) / spacing, static_cast<double>(nx_) - 1.001);
    const double gy = std::min((y - extent_.y_low) / spacing, static_cast<double>(ny_) - 1.001);
    const auto i = static_cast<std::ptrdiff_t>(gx), j = static_cast<std::ptrdiff_t>(gy);
    const auto value = [&](std::ptrdiff_t ii, std::ptrdiff_t jj) {
        ii = std::clamp<std::ptrdiff_t>(ii, 0, static_cast<std::ptrdiff_t>(nx_) - 1);
        jj = std::clamp<std::ptrdiff_t>(jj, 0, static_cast<std::ptrdiff_t>(ny_) - 1);
        return double{plane[static_cast<std::size_t>(jj) * nx_ + static_cast<std::size_t>(ii)]};
    };
    const auto wx = cubic(gx - static_cast<double>(i)), wy = cubic(gy - static_cast<double>(j));
    double sum = 0;
    for (std::ptrdiff_t l = 0; l < 4; ++l)
        for (std::ptrdiff_t k = 0; k < 4; ++k)
            sum += wy[static_cast<std::size_t>(l)] * wx[static_cast<std::size_t>(k)] * value(i + k - 1, j + l - 1);
    const auto [low, high] = std::minmax({value(i, j), value(i + 1, j), value(i, j + 1), value(i + 1, j + 1)});
    return static_cast<float>(std::clamp(sum, low, high));
}

float Dye::at(double x, double y, double u, double v, double time) const {
    // Displaces both phases along the flow before it interpolates. Otherwise each filament would appear twice.
    const double phase = (time - std::floor(time)) * phases;
    const double whole = std::floor(phase), part = phase - whole;
    const auto before = static_cast<std::size_t>(whole) % phases, after = (before + 1) % phases;
    const double back = part / phases, on = (1 - part) / phases;
    const double carried = (1 - part) * double{sample(planes_[before], x - back * u, y - back * v)} +
                           part * double{sample(planes_[after], x + on * u, y + on * v)};
    return std::max(static_cast<float>(carried), static_cast<float>(source(x, y)));
}

} // namespace server::demo
