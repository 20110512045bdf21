// Fans from the first corner that is good enough: polygons of cells are mostly convex, and nearly flat.
#include "ciel/parallel.hpp"
#include "ciel/polygon.hpp"

#include <algorithm>
#include <limits>

namespace ciel {

namespace {

using Triangles = std::vector<Index>;

double dot(const Vec3d& a, const Vec3d& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec3d triangle_area(const Surface& surface, Index a, Index b, Index c) {
    return cross(arm(surface.positions[a], surface.positions[b]), arm(surface.positions[a], surface.positions[c]));
}

// The least area that a triangle of the fan from `corner` has towards the polygon's normal.
double worst_area(const Surface& surface, std::span<const Index> loop, const Vec3d& normal, std::size_t corner) {
    const std::size_t n = loop.size();
    double worst = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i + 1 < n; ++i)
        worst = std::min(worst, dot(normal, triangle_area(surface, loop[corner], loop[(corner + i) % n],
                                                          loop[(corner + i + 1) % n])));
    return worst;
}

std::size_t best_corner(const Surface& surface, std::span<const Index> loop) {
    if (loop.size() == 3) return 0;
    const Vec3d normal = area_vector(surface.positions, loop);
    const double fair = 0.05 * dot(normal, normal) / static_cast<double>(loop.size() - 2);
    std::size_t best = 0;
    double best_worst = -std::numeric_limits<double>::infinity();
    for (std::size_t corner = 0; corner < loop.size() && best_worst < fair; ++corner) {
        const double worst = worst_area(surface, loop, normal, corner);
        if (worst > best_worst) {
            best_worst = worst;
            best = corner;
        }
    }
    return best;
}

void append_fan(const Surface& surface, std::span<const Index> loop, Triangles& out) {
    const std::size_t corner = best_corner(surface, loop), n = loop.size();
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const Index a = loop[corner], b = loop[(corner + i) % n], c = loop[(corner + i + 1) % n];
        const Vec3d area = triangle_area(surface, a, b, c);
        if (a == b || b == c || c == a || dot(area, area) == 0) continue;
        out.insert(out.end(), {a, b, c});
    }
}

} // namespace

Triangles triangulate(const Surface& surface) {
    constexpr std::size_t chunk = 4096;
    const std::size_t polygons = surface.polygon_cell.size();
    std::vector<Triangles> parts((polygons + chunk - 1) / chunk);
    parallel_for(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end; ++part)
            for (std::size_t i = part * chunk; i < std::min(polygons, (part + 1) * chunk); ++i)
                append_fan(surface, polygon(surface, i), parts[part]);
    });
    std::size_t size = 0;
    for (const Triangles& part : parts) size += part.size();
    Triangles out;
    out.reserve(size);
    for (const Triangles& part : parts) out.insert(out.end(), part.begin(), part.end());
    return out;
}

} // namespace ciel
