#include "mesh/mesh_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ciel::detail {

namespace {

template <class Number>
std::vector<Number> in_order(const ArrayView& points, std::span<const Index> order) {
    const std::size_t count = order.empty() ? points.rows() : order.size();
    std::vector<Number> out(3 * count);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            out[3 * i + axis] = static_cast<Number>(points.real(order.empty() ? i : order[i], axis));
    return out;
}

} // namespace

MeshPoints mesh_points(const ArrayView& points, std::span<const Index> order) {
    if (points.type() == NumberType::float32) return {in_order<float>(points, order), {}};
    std::vector<double> doubles = in_order<double>(points, order);
    if (!are_floats(doubles)) return {{}, std::move(doubles)};
    return {{doubles.begin(), doubles.end()}, {}};
}

Vec3d middle_of(const ArrayView& points) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vec3d middle{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double low = infinity, high = -infinity;
        for (std::size_t i = 0; i < points.rows(); ++i) {
            const double at = points.real(i, axis);
            if (!std::isfinite(at)) continue;
            low = std::min(low, at);
            high = std::max(high, at);
        }
        if (low <= high) middle[axis] = low + (high - low) / 2;
    }
    return middle;
}

} // namespace ciel::detail
