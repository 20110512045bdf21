#include "session/shown_bounds.hpp"

#include "session/cut_box.hpp"
#include "session/cutter.hpp"

#include <algorithm>
#include <cmath>

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
        for (const Vec3d& corner : corners_of_cut_box(geometry, geometry.clip)) box.add(corner);
    }
    return box.is_empty() ? whole : box.from(geometry.origin);
}

} // namespace ciel::session
