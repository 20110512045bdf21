// Triangulates polygons as fans. The fan starts at the first corner that is good enough, because polygons of cells are
// mostly convex and nearly flat. If every fan folds over, the polygon is triangulated by ear clipping.
#include "ciel/parallel.hpp"
#include "extraction/polygon.hpp"
#include "polygons/ear_clipping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ciel {

using detail::area_vector;
using detail::clip_ears;
using detail::polygon;

namespace {

// The buffer has room for corners - 2 triangles of each polygon; `fill` marks the unused rest.
class Triangles {
public:
    explicit Triangles(Index* to) : to_(to) {}

    void add(Index a, Index b, Index c) {
        to_[0] = a;
        to_[1] = b;
        to_[2] = c;
        to_ += 3;
    }
    void fill(Index* end) { to_ = std::fill_n(to_, end - to_, none); }

private:
    Index* to_;
};

Vec3d triangle_area(const Surface& surface, Index a, Index b, Index c) {
    return cross(arm(surface.positions[a], surface.positions[b]), arm(surface.positions[a], surface.positions[c]));
}

double worst_area(const Surface& surface, std::span<const Index> loop, const Vec3d& normal, std::size_t corner) {
    const std::size_t n = loop.size();
    double worst = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i + 1 < n; ++i)
        worst = std::min(worst, dot(normal, triangle_area(surface, loop[corner], loop[(corner + i) % n],
                                                          loop[(corner + i + 1) % n])));
    return worst;
}

struct Fan {
    std::size_t corner = 0;
    bool folds = false; // true if each tried fan has a reversed triangle of over 5 % of the mean area
};

// Of at most 127 corners, all are tried. Of more, 64 to 96 evenly spaced corners are tried, so that the time is linear.
constexpr std::size_t most_tried = 64;

Fan best_fan(const Surface& surface, std::span<const Index> loop, const Vec3d& normal) {
    const double fair = 0.05 * dot(normal, normal) / static_cast<double>(loop.size() - 2);
    Fan best;
    double best_worst = -std::numeric_limits<double>::infinity();
    const std::size_t step = std::max<std::size_t>(1, loop.size() / most_tried);
    for (std::size_t corner = 0; corner < loop.size() && best_worst < fair; corner += step) {
        const double worst = worst_area(surface, loop, normal, corner);
        if (worst > best_worst) {
            best_worst = worst;
            best.corner = corner;
        }
    }
    best.folds = best_worst < -fair;
    return best;
}

void append(const Surface& surface, Index a, Index b, Index c, Triangles& out) {
    const Vec3d area = triangle_area(surface, a, b, c);
    if (a == b || b == c || c == a || dot(area, area) == 0) return;
    out.add(a, b, c);
}

void append_ears(const Surface& surface, std::span<const Index> loop, const Vec3d& normal, Triangles& out) {
    std::size_t axis = 0;
    for (const std::size_t other : {1U, 2U})
        if (std::abs(normal[other]) > std::abs(normal[axis])) axis = other;
    const bool from_behind = normal[axis] < 0;
    const std::size_t right = (axis + (from_behind ? 2 : 1)) % 3, up = (axis + (from_behind ? 1 : 2)) % 3;
    std::vector<std::array<double, 2>> flat;
    flat.reserve(loop.size());
    for (const Index p : loop) flat.push_back({surface.positions[p][right], surface.positions[p][up]});
    std::vector<Index> places;
    clip_ears(flat, places);
    for (std::size_t t = 0; t < places.size(); t += 3)
        append(surface, loop[places[t]], loop[places[t + 1]], loop[places[t + 2]], out);
}

void append_triangles(const Surface& surface, std::span<const Index> loop, Triangles& out) {
    const std::size_t n = loop.size();
    if (n == 3) return append(surface, loop[0], loop[1], loop[2], out);
    const Vec3d normal = area_vector(surface.positions, loop);
    const Fan fan = best_fan(surface, loop, normal);
    if (fan.folds) return append_ears(surface, loop, normal, out);
    for (std::size_t i = 1; i + 1 < n; ++i)
        append(surface, loop[fan.corner], loop[(fan.corner + i) % n], loop[(fan.corner + i + 1) % n], out);
}

// Returns the place of the polygon's triangles in the buffer. Each earlier polygon has room for corners - 2 triangles.
std::size_t place_of(const Surface& surface, std::size_t polygon) {
    return 3 * (std::size_t{surface.polygon_offset[polygon]} - 2 * polygon);
}

} // namespace

void triangulate(const Surface& surface, std::vector<Index>& out) {
    constexpr std::size_t chunk = 4096;
    const std::size_t polygons = surface.polygon_cell.size(), chunks = (polygons + chunk - 1) / chunk;
    out.resize(place_of(surface, polygons));
    parallel_for(chunks, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t first = begin * chunk; first < std::min(polygons, end * chunk); first += chunk) {
            const std::size_t last = std::min(polygons, first + chunk);
            Triangles to(out.data() + place_of(surface, first));
            for (std::size_t i = first; i < last; ++i) append_triangles(surface, polygon(surface, i), to);
            to.fill(out.data() + place_of(surface, last));
        }
    });
    std::erase(out, none); // removes the entries of triangles that were left out
}

std::vector<Index> triangulate(const Surface& surface) {
    std::vector<Index> out;
    triangulate(surface, out);
    return out;
}

} // namespace ciel
