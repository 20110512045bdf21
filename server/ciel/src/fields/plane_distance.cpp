#include "fields/plane_distance.hpp"

#include "ciel/field.hpp"
#include "ciel/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ciel {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

} // namespace

// The distance of a box's vertices lies between those of two opposite corners. One step further, because the distance
// of a vertex is rounded.
BlockRanges PlaneDistance::ranges(const BlockBoxes& boxes) const {
    const std::size_t blocks = boxes[0].low.size();
    BlockRanges out{std::vector<double>(blocks), std::vector<double>(blocks), boxes[0].missing};
    for (std::size_t b = 0; b < blocks; ++b) {
        double low = shift_, high = shift_;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double from = normal_[axis] * boxes[axis].low[b], to = normal_[axis] * boxes[axis].high[b];
            low += std::min(from, to);
            high += std::max(from, to);
        }
        out.low[b] = std::nextafter(static_cast<float>(low), -infinity);
        out.high[b] = std::nextafter(static_cast<float>(high), infinity);
    }
    return out;
}

// Looks into blocks in the order of their bounds, until no other block can have a farther vertex.
std::array<double, 2> PlaneDistance::range(const BlockRanges& bounds, std::span<const Index> first_vertex) const {
    std::vector<Index> order(bounds.low.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::array<double, 2> range{infinity, -infinity};
    std::ranges::sort(order, {}, [&](Index b) { return bounds.low[b]; });
    for (const Index b : order) {
        if (bounds.low[b] >= range[0]) break;
        for (Index v = first_vertex[b]; v < first_vertex[b + 1]; ++v) range[0] = std::min(range[0], double{at(v)});
    }
    std::ranges::sort(order, std::greater<>(), [&](Index b) { return bounds.high[b]; });
    for (const Index b : order) {
        if (bounds.high[b] <= range[1]) break;
        for (Index v = first_vertex[b]; v < first_vertex[b + 1]; ++v) range[1] = std::max(range[1], double{at(v)});
    }
    return range[0] <= range[1] ? range : std::array<double, 2>{};
}

std::vector<float> plane_distance(const FaceMeshView& mesh, Vec3d origin, Vec3d normal) {
    std::vector<float> out(mesh.vertex_count());
    const PlaneDistance distance(mesh, origin, normal);
    parallel_for(out.size(), 65536, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) out[v] = distance.at(v);
    });
    return out;
}

} // namespace ciel
