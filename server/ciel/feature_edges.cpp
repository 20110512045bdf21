#include "ciel/feature_edges.hpp"

#include "ciel/polygon.hpp"

#include <algorithm>
#include <numbers>

namespace ciel {

namespace {

struct Side { // of a polygon, at its edge's lower point
    Index upper, polygon;
    friend bool operator<(const Side& a, const Side& b) {
        return a.upper != b.upper ? a.upper < b.upper : a.polygon < b.polygon;
    }
};

template <class F>
void for_sides(const Surface& surface, F&& f) {
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        const std::span<const Index> loop = polygon(surface, i);
        Index before = loop.back();
        for (const Index point : loop) {
            if (point != before) f(std::min(point, before), Side{std::max(point, before), static_cast<Index>(i)});
            before = point;
        }
    }
}

bool bends(const Vec3f& a, const Vec3f& b, double cosine) {
    const double dot =
        static_cast<double>(a[0]) * b[0] + static_cast<double>(a[1]) * b[1] + static_cast<double>(a[2]) * b[2];
    return a != Vec3f{} && b != Vec3f{} && dot < cosine;
}

} // namespace

std::vector<Index> feature_edges(const Surface& surface, double degrees) {
    // Rounding makes flat surfaces bend by parts of a degree.
    const double cosine = std::cos(degrees * std::numbers::pi / 180) - 1e-6;
    std::vector<Vec3f> normals;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i)
        normals.push_back(unit(area_vector(surface.positions, polygon(surface, i))));
    std::vector<Index> begin(surface.positions.size() + 2);
    for_sides(surface, [&](Index lower, Side) { ++begin[lower + 2]; });
    for (std::size_t i = 2; i < begin.size(); ++i) begin[i] += begin[i - 1];
    std::vector<Side> sides(begin.back());
    for_sides(surface, [&](Index lower, Side side) { sides[begin[lower + 1]++] = side; });

    std::vector<Index> edges;
    for (Index lower = 0; lower < surface.positions.size(); ++lower) {
        const auto end = sides.begin() + begin[lower + 1];
        std::sort(sides.begin() + begin[lower], end);
        for (auto first = sides.begin() + begin[lower]; first != end;) {
            const auto last = std::find_if(first, end, [&](const Side& side) { return side.upper != first->upper; });
            if (last - first != 2 || bends(normals[first->polygon], normals[(first + 1)->polygon], cosine))
                edges.insert(edges.end(), {lower, first->upper});
            first = last;
        }
    }
    return edges;
}

} // namespace ciel
