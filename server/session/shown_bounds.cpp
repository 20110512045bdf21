#include "session/shown_bounds.hpp"

#include "session/cutter.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ciel::session {
namespace {

class Box {
public:
    void add(const Vec3d& point) {
        for (std::size_t k = 0; k < 3; ++k) {
            low_[k] = std::min(low_[k], point[k]);
            high_[k] = std::max(high_[k], point[k]);
        }
    }
    [[nodiscard]] bool is_empty() const { return low_[0] > high_[0]; }
    [[nodiscard]] BoundingBox from(const Vec3d& origin) const {
        BoundingBox box;
        for (std::size_t k = 0; k < 3; ++k) {
            box.low[k] = origin[k] + low_[k];
            box.high[k] = origin[k] + high_[k];
        }
        return box;
    }

private:
    Vec3d low_{INFINITY, INFINITY, INFINITY}, high_{-INFINITY, -INFINITY, -INFINITY};
};

std::optional<Vec3d> meet(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c) {
    const auto cross = [](const Vec3d& u, const Vec3d& v) {
        return Vec3d{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    };
    const Vec3d bc = cross(b.normal, c.normal);
    const Vec3d ca = cross(c.normal, a.normal);
    const Vec3d ab = cross(a.normal, b.normal);
    const double volume = a.normal[0] * bc[0] + a.normal[1] * bc[1] + a.normal[2] * bc[2];
    if (!(std::abs(volume) > 1e-9)) return {};
    Vec3d point{};
    for (std::size_t k = 0; k < 3; ++k) point[k] = -(a.offset * bc[k] + b.offset * ca[k] + c.offset * ab[k]) / volume;
    return point;
}

std::vector<HalfSpace> unit_length(std::vector<HalfSpace> planes) {
    for (HalfSpace& plane : planes) {
        const double length = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
        for (double& component : plane.normal) component /= length;
        plane.offset /= length;
    }
    return planes;
}

// The mesh's box as the planes cut it: the corners of a convex body are where three of its planes meet inside all.
void add_box(Box& box, const Geometry& geometry) {
    std::vector<HalfSpace> planes = unit_length(geometry.clip);
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double low = geometry.bounds_min[k] - geometry.origin[k];
        const double high = geometry.bounds_max[k] - geometry.origin[k];
        size = std::max({size, std::abs(low), std::abs(high)});
        Vec3d inward{};
        inward[k] = 1;
        planes.push_back({inward, -low});
        inward[k] = -1;
        planes.push_back({inward, high});
    }
    const double rounding = 1e-9 * size;
    for (std::size_t i = 0; i < planes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            for (std::size_t k = 0; k < j; ++k)
                if (const auto corner = meet(planes[i], planes[j], planes[k]);
                    corner && std::all_of(planes.begin(), planes.end(), [&](const HalfSpace& plane) {
                        return distance(plane, *corner) >= -rounding;
                    }))
                    box.add(*corner);
}

void add_drawable(Box& box, const Drawable& drawable, const Cutter& cutter) {
    const std::span<const Index> indices = drawable.indices();
    const auto& positions = drawable.shape->surface.positions;
    const std::size_t corners = corners_of(drawable);
    for (std::size_t i = 0; i + corners <= indices.size(); i += corners) {
        const auto piece = indices.subspan(i, corners);
        if (std::all_of(piece.begin(), piece.end(), [&](Index at) { return cutter.keeps(positions[at]); })) {
            for (const Index at : piece) box.add(wide(positions[at]));
            continue;
        }
        std::vector<Vec3d> whole;
        for (const Index at : piece) whole.push_back(wide(positions[at]));
        for (const Vec3d& point : cutter.rest_of(std::move(whole))) box.add(point);
    }
}

bool shows_data(const scene::Layer& layer) {
    return layer.visible && !std::holds_alternative<scene::OutlineLayer>(layer.kind) &&
           !std::holds_alternative<scene::ClipLayer>(layer.kind);
}

bool has_threshold(const scene::Layer& layer) {
    return std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.threshold; })
                return kind.threshold.has_value();
            else
                return false;
        },
        layer.kind);
}

} // namespace

BoundingBox shown_bounds(const Geometry& geometry, const scene::Scene& scene) {
    const BoundingBox whole{geometry.bounds_min, geometry.bounds_max};
    std::vector<const scene::Layer*> shown;
    for (const scene::Layer& layer : scene.layers)
        if (shows_data(layer)) shown.push_back(&layer);
    const bool all_have_thresholds = !shown.empty() && std::all_of(shown.begin(), shown.end(), [](const auto* layer) {
        return has_threshold(*layer);
    });
    if (geometry.clip.empty() && !all_have_thresholds) return whole;
    Box box;
    if (all_have_thresholds) {
        const Cutter cutter(geometry);
        for (const Drawable& drawable : geometry.drawables)
            if (std::any_of(shown.begin(), shown.end(), [&](const auto* layer) { return layer->id == drawable.layer; }))
                add_drawable(box, drawable, cutter);
    } else {
        add_box(box, geometry);
    }
    return box.is_empty() ? whole : box.from(geometry.origin);
}

} // namespace ciel::session
