#include "ciel/contour_lines.hpp"

#include "ciel/parallel.hpp"
#include "extraction/edge_points.hpp"
#include "extraction/polygon.hpp"

#include <algorithm>
#include <limits>

namespace ciel {

using detail::polygon;
using detail::share_at;

namespace {

template <class T>
class PolygonContours {
public:
    PolygonContours(const Surface& surface, std::span<const T> values) : surface_(surface), values_(values) {}

    // Each segment leads from the side where the loop enters a run of high corners to the side where it leaves the run.
    void append(std::span<const Index> loop, double nu, std::vector<Vec3f>& out) const {
        const auto high = [&](std::size_t i) { return values_[loop[i % loop.size()]] >= nu; };
        for (std::size_t i = 0; i < loop.size(); ++i) {
            if (high(i) || !high(i + 1)) continue;
            std::size_t end = i + 1; // last corner of the run
            while (high(end + 1)) ++end;
            out.push_back(crossing(loop[i], loop[(i + 1) % loop.size()], nu));
            out.push_back(crossing(loop[end % loop.size()], loop[(end + 1) % loop.size()], nu));
        }
    }

    [[nodiscard]] bool crosses(std::span<const Index> loop, double lowest, double highest) const {
        bool below = false, above = false;
        for (const Index point : loop) {
            if (!std::isfinite(values_[point])) return false;
            below = below || values_[point] < highest;
            above = above || values_[point] >= lowest;
        }
        return below && above;
    }

private:
    // Interpolates from the lower index to the higher, so that both polygons of the side get the same bits.
    [[nodiscard]] Vec3f crossing(Index a, Index b, double nu) const {
        if (a > b) std::swap(a, b);
        const double t = share_at(nu, values_[a], values_[b]);
        const Vec3f &p = surface_.positions[a], &q = surface_.positions[b];
        return {lerp(p[0], q[0], t), lerp(p[1], q[1], t), lerp(p[2], q[2], t)};
    }

    const Surface& surface_;
    std::span<const T> values_;
};

template <class T>
std::vector<Vec3f> lines_of(const Surface& surface, std::span<const T> values, std::span<const double> at) {
    constexpr std::size_t chunk = 4096;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const double nu : at) { // a NaN changes neither lowest nor highest
        lowest = std::min(lowest, nu);
        highest = std::max(highest, nu);
    }
    const PolygonContours contours(surface, values);
    const std::size_t polygons = surface.polygon_cell.size(), chunks = (polygons + chunk - 1) / chunk;
    std::vector<std::vector<Vec3f>> parts(chunks * at.size());
    parallel_for(chunks, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end; ++part)
            for (std::size_t i = part * chunk; i < std::min(polygons, (part + 1) * chunk); ++i) {
                const std::span<const Index> loop = polygon(surface, i);
                if (!contours.crosses(loop, lowest, highest)) continue;
                for (std::size_t k = 0; k < at.size(); ++k) contours.append(loop, at[k], parts[k * chunks + part]);
            }
    });
    std::vector<Vec3f> out;
    for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
    return out;
}

} // namespace

std::vector<Vec3f> contour_lines(const Surface& surface, ValuesView values, std::span<const double> at) {
    if (values.size() != surface.positions.size())
        fail("contour lines need one value for each point of the surface; pass as many values as the surface has "
             "points");
    if (at.empty()) return {};
    return values.with([&](auto all) { return lines_of(surface, all, at); });
}

} // namespace ciel
