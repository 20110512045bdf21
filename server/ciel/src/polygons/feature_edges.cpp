#include "ciel/feature_edges.hpp"

#include "polygons/polygon_sides.hpp"

#include <numbers>

namespace ciel {

using detail::area_vector;
using detail::polygon;
using detail::polygon_sides;

namespace {

// A side of a polygon, in the list of its lower point.
struct Side {
    Index upper, polygon;
    friend bool operator<(const Side& a, const Side& b) {
        return a.upper != b.upper ? a.upper < b.upper : a.polygon < b.polygon;
    }
};

bool bends(const Vec3f& a, const Vec3f& b, double cosine) { return a != Vec3f{} && b != Vec3f{} && dot(a, b) < cosine; }

} // namespace

std::vector<Index> feature_edges(const Surface& surface, double degrees) {
    // The tolerance of 1e-6 is needed because rounding bends flat surfaces by a small fraction of a degree.
    const double cosine = std::cos(degrees * std::numbers::pi / 180) - 1e-6;
    std::vector<Vec3f> normals;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i)
        normals.push_back(unit(area_vector(surface.positions, polygon(surface, i))));
    auto sides = polygon_sides(surface, [](Index upper, Index polygon) { return Side{upper, polygon}; });

    std::vector<Index> edges;
    for (Index lower = 0; lower < surface.positions.size(); ++lower) {
        const std::span<Side> all = sides.of(lower);
        for (auto first = all.begin(); first != all.end();) {
            const auto last =
                std::find_if(first, all.end(), [&](const Side& side) { return side.upper != first->upper; });
            if (last - first != 2 || bends(normals[first->polygon], normals[(first + 1)->polygon], cosine))
                edges.insert(edges.end(), {lower, first->upper});
            first = last;
        }
    }
    return edges;
}

} // namespace ciel
