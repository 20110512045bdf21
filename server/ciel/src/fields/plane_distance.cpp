#include "fields/plane_distance.hpp"

#include "ciel/field.hpp"
#include "ciel/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ciel::detail {

namespace {

template <class Number>
constexpr Number infinity = std::numeric_limits<Number>::infinity();

template <class Number>
std::array<double, 2> one_step_wider(double low, double high) {
    return {std::nextafter(static_cast<Number>(low), -infinity<Number>),
            std::nextafter(static_cast<Number>(high), infinity<Number>)};
}

} // namespace

// The range is wider by `slack` and by one floating-point number at each end, because distances are rounded.
BlockRanges PlaneDistance::ranges(const BlockBoxes& boxes) const {
    const std::size_t blocks = boxes[0].low.size();
    BlockRanges out{std::vector<double>(blocks), std::vector<double>(blocks), boxes[0].missing};
    for (std::size_t b = 0; b < blocks; ++b) {
        double low = shift_, high = shift_, largest = std::abs(shift_);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double from = normal_[axis] * boxes[axis].low[b], to = normal_[axis] * boxes[axis].high[b];
            low += std::min(from, to);
            high += std::max(from, to);
            largest += std::max(std::abs(from), std::abs(to));
        }
        const double slack = 8 * std::numeric_limits<double>::epsilon() * largest;
        const std::array<double, 2> range = has_doubles() ? one_step_wider<double>(low - slack, high + slack)
                                                          : one_step_wider<float>(low - slack, high + slack);
        out.low[b] = range[0];
        out.high[b] = range[1];
    }
    return out;
}

// Reads the blocks in the order of their bounds, until no block can have a lower (for the maximum, higher) distance.
std::array<double, 2> PlaneDistance::range(const BlockRanges& bounds, std::span<const Index> first_vertex) const {
    std::vector<Index> order(bounds.low.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::array<double, 2> range{infinity<double>, -infinity<double>};
    const auto load = [&](Index b) {
        if (loader_ != nullptr && first_vertex[b] < first_vertex[b + 1])
            loader_->load(first_vertex[b], first_vertex[b + 1]);
    };
    std::ranges::sort(order, {}, [&](Index b) { return bounds.low[b]; });
    for (const Index b : order) {
        if (bounds.low[b] >= range[0]) break;
        load(b);
        for (Index v = first_vertex[b]; v < first_vertex[b + 1]; ++v) range[0] = std::min(range[0], at(v));
    }
    std::ranges::sort(order, std::greater<>(), [&](Index b) { return bounds.high[b]; });
    for (const Index b : order) {
        if (bounds.high[b] <= range[1]) break;
        load(b);
        for (Index v = first_vertex[b]; v < first_vertex[b + 1]; ++v) range[1] = std::max(range[1], at(v));
    }
    return range[0] <= range[1] ? range : std::array<double, 2>{};
}

template <class Number>
std::vector<Number> plane_distances(const FaceMeshView& mesh, const Vec3d& origin, const Vec3d& normal) {
    std::vector<Number> out(mesh.vertex_count());
    const PlaneDistance distance(mesh, origin, normal);
    const auto fill = [&](const auto& of) {
        parallel_for(out.size(), 65536, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) out[v] = static_cast<Number>(of.at(v));
        });
    };
    distance.has_doubles() ? fill(distance.of<double>()) : fill(distance.of<float>());
    return out;
}
template std::vector<float> plane_distances(const FaceMeshView&, const Vec3d&, const Vec3d&);
template std::vector<double> plane_distances(const FaceMeshView&, const Vec3d&, const Vec3d&);

} // namespace ciel::detail

namespace ciel {

std::vector<float> plane_distance(const FaceMeshView& mesh, Vec3d origin, Vec3d normal) {
    return detail::plane_distances<float>(mesh, origin, normal);
}

} // namespace ciel
