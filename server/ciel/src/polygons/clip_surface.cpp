#include "ciel/clip_surface.hpp"

#include "ciel/clip_polygon.hpp"
#include "extraction/polygon.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace ciel {

using detail::polygon;

namespace {

class PlaneClip {
public:
    PlaneClip(ClippedSurface&& in, const HalfSpace& plane, double slack) : in_(std::move(in)), slack_(slack) {
        const auto measure = [&](const auto& positions) {
            for (const auto& p : positions) distance_.push_back(dot(plane.normal, p) + plane.offset);
        };
        in_.places.empty() ? measure(in_.surface.positions) : measure(in_.places);
    }

    [[nodiscard]] ClippedSurface run() {
        place_kept_vertices();
        for (std::size_t i = 0; i < in_.surface.polygon_cell.size(); ++i) clip(i);
        return std::move(out_);
    }

private:
    [[nodiscard]] bool keeps(Index v) const { return distance_[v] >= -slack_; }

    void place_kept_vertices() {
        place_.assign(distance_.size(), none);
        for (Index v = 0; v < distance_.size(); ++v) {
            if (!keeps(v)) continue;
            place_[v] = static_cast<Index>(out_.surface.positions.size());
            out_.surface.positions.push_back(in_.surface.positions[v]);
            if (!in_.surface.normals.empty()) out_.surface.normals.push_back(in_.surface.normals[v]);
            if (v < in_.surface.points.size()) out_.surface.points.push_back(in_.surface.points[v]);
            if (!in_.values.empty()) out_.values.push_back(in_.values[v]);
            if (!in_.places.empty()) out_.places.push_back(in_.places[v]);
        }
    }

    void clip(std::size_t i) {
        loop_.clear();
        walk_kept_part(
            polygon(in_.surface, i), [this](Index v) { return keeps(v); },
            [this](Index v) { loop_.push_back(place_[v]); },
            [this](Index from, Index to) { loop_.push_back(crossing(from, to)); });
        if (loop_.size() < 3) return;
        out_.surface.polygon_vertex.insert(out_.surface.polygon_vertex.end(), loop_.begin(), loop_.end());
        out_.surface.polygon_offset.push_back(static_cast<Index>(out_.surface.polygon_vertex.size()));
        out_.surface.polygon_cell.push_back(in_.surface.polygon_cell[i]);
    }

    // Interpolates from the end that is nearer to the plane, since the rounding error of a far end may be larger than
    // the distance of the near one. The choice depends on the two vertices only, so that both polygons of the side get
    // the same bits.
    Index crossing(Index from, Index to) {
        if (!keeps(from)) std::swap(from, to);
        const auto [known, is_new] =
            crossings_.try_emplace({from, to}, static_cast<Index>(out_.surface.positions.size()));
        if (!is_new) return known->second;
        const double inside = std::max(distance_[from], 0.0), outside = -distance_[to];
        if (outside < inside) std::swap(from, to);
        const double t = std::min(inside, outside) / (inside + outside);
        const auto mixed = [t]<class Vector>(const Vector& a, const Vector& b) {
            return Vector{lerp(a[0], b[0], t), lerp(a[1], b[1], t), lerp(a[2], b[2], t)};
        };
        const Surface& in = in_.surface;
        out_.surface.positions.push_back(mixed(in.positions[from], in.positions[to]));
        if (!in.normals.empty()) {
            const Vec3f sum = mixed(in.normals[from], in.normals[to]);
            out_.surface.normals.push_back(unit({sum[0], sum[1], sum[2]}));
        }
        if (!in_.values.empty()) out_.values.push_back(lerp(in_.values[from], in_.values[to], t));
        if (!in_.places.empty()) out_.places.push_back(mixed(in_.places[from], in_.places[to]));
        return known->second;
    }

    ClippedSurface in_, out_;
    double slack_;
    std::vector<double> distance_;
    std::vector<Index> place_, loop_;
    std::map<std::pair<Index, Index>, Index> crossings_; // (kept vertex, removed vertex) -> new vertex
};

} // namespace

ClippedSurface clip_surface(const Surface& surface, ValuesView values, std::span<const HalfSpace> planes, double slack,
                            std::span<const Vec3d> places) {
    if (!values.empty() && values.size() != surface.positions.size())
        fail("clipping a surface needs one value for each vertex of the surface, or no values");
    if (!places.empty() && places.size() != surface.positions.size())
        fail("clipping a surface needs one place for each vertex of the surface, or no places");
    ClippedSurface out{surface, {values.begin(), values.end()}, {places.begin(), places.end()}};
    out.surface.chunks.clear();
    for (const HalfSpace& plane : planes) out = PlaneClip(std::move(out), plane, slack).run();
    return out;
}

} // namespace ciel
