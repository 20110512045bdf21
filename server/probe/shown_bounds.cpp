#include "probe/shown_bounds.hpp"

#include "annotations/camera.hpp"
#include "geometry/clip_planes.hpp"
#include "geometry/cut_box.hpp"
#include "geometry/viewpoint.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>

namespace server::probe {
namespace {

class Box {
public:
    void add(const ciel::Vec3d& point) {
        for (std::size_t k = 0; k < 3; ++k) {
            low_[k] = std::min(low_[k], point[k]);
            high_[k] = std::max(high_[k], point[k]);
        }
    }
    [[nodiscard]] bool is_empty() const { return low_[0] > high_[0]; }
    [[nodiscard]] geometry::BoundingBox from(const ciel::Vec3d& origin) const {
        geometry::BoundingBox box;
        for (std::size_t k = 0; k < 3; ++k) {
            box.low[k] = origin[k] + low_[k];
            box.high[k] = origin[k] + high_[k];
        }
        return box;
    }

private:
    ciel::Vec3d low_{INFINITY, INFINITY, INFINITY}, high_{-INFINITY, -INFINITY, -INFINITY};
};

void add_drawable(Box& box, const geometry::Drawable& drawable, const geometry::ClipPlanes& cutter) {
    const std::span<const ciel::Index> indices = drawable.indices();
    const auto& positions = drawable.shape->surface.positions;
    const std::size_t corners = drawable.corners();
    for (std::size_t i = 0; i + corners <= indices.size(); i += corners) {
        const auto piece = indices.subspan(i, corners);
        if (std::all_of(piece.begin(), piece.end(), [&](ciel::Index at) { return cutter.keeps(positions[at]); })) {
            for (const ciel::Index at : piece) box.add(geometry::wide(positions[at]));
            continue;
        }
        std::vector<ciel::Vec3d> whole;
        for (const ciel::Index at : piece) whole.push_back(geometry::wide(positions[at]));
        for (const ciel::Vec3d& point : cutter.rest_of(std::move(whole))) box.add(point);
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

bool shows_part(const scene::Layer& layer) {
    if (has_threshold(layer)) return true;
    return std::visit(
        [](const auto& kind) {
            if constexpr (requires { kind.groups; })
                return !kind.groups.empty();
            else
                return false;
        },
        layer.kind);
}

bool is_iso(const scene::Layer& layer) { return std::holds_alternative<scene::IsoLayer>(layer.kind); }

template <class Counts>
Box box_of(const geometry::Geometry& geometry, const std::vector<scene::Layer>& layers, Counts counts) {
    Box box;
    const geometry::ClipPlanes cutter(geometry);
    for (const scene::Layer& layer : layers) {
        if (!shows_data(layer) || !counts(layer)) continue;
        for (const geometry::Drawable& drawable : geometry.drawables)
            if (drawable.layer == layer.id) add_drawable(box, drawable, cutter);
        for (const geometry::VolumeDrawable& volume : geometry.volumes)
            if (volume.layer == layer.id)
                for (const ciel::Vec3d& corner : geometry::corners_of_cut_box(geometry, geometry.clip)) box.add(corner);
    }
    return box;
}

// The frustum of the scene's view. Positions are offsets from the geometry's origin.
class ViewFrustum {
public:
    ViewFrustum(const geometry::Geometry& geometry, const scene::CheckedScene& checked, geometry::ViewSize size) {
        const auto view = annotations::view_transform(
            geometry::viewpoint_of(geometry, checked, static_cast<int>(size.width), static_cast<int>(size.height)));
        clip_of_ = view.projection * view.view;
    }
    [[nodiscard]] bool shows(const ciel::Vec3f& at) const {
        const glm::dvec4 clip = clip_of_ * glm::dvec4(at[0], at[1], at[2], 1);
        return clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && std::abs(clip.z) <= clip.w;
    }

private:
    glm::dmat4 clip_of_{};
};

template <class Counts>
Box box_in_view(const geometry::Geometry& geometry, const std::vector<scene::Layer>& layers, const ViewFrustum& view,
                Counts counts) {
    Box box;
    const geometry::ClipPlanes cutter(geometry);
    for (const scene::Layer& layer : layers) {
        if (!shows_data(layer) || !counts(layer)) continue;
        for (const geometry::Drawable& drawable : geometry.drawables) {
            if (drawable.layer != layer.id) continue;
            for (const ciel::Vec3f& at : drawable.shape->surface.positions)
                if (view.shows(at) && cutter.keeps(at)) box.add(geometry::wide(at));
        }
    }
    return box;
}

} // namespace

std::optional<geometry::BoundingBox> bounds_in_view(const geometry::Geometry& geometry,
                                                    const scene::CheckedScene& checked, geometry::ViewSize size) {
    const ViewFrustum view(geometry, checked, size);
    const std::vector<scene::Layer>& layers = checked.scene().layers;
    Box box = box_in_view(geometry, layers, view, shows_part);
    if (box.is_empty()) box = box_in_view(geometry, layers, view, [](const scene::Layer&) { return true; });
    return box.is_empty() ? std::nullopt : std::optional(box.from(geometry.origin));
}

geometry::BoundingBox drawn_bounds(const geometry::Geometry& geometry, const scene::CheckedScene& checked) {
    const std::vector<scene::Layer>& layers = checked.scene().layers;
    if (!box_of(geometry, layers, shows_part).is_empty()) {
        const auto counts = [](const scene::Layer& layer) { return shows_part(layer) || is_iso(layer); };
        return box_of(geometry, layers, counts).from(geometry.origin);
    }
    const Box all = box_of(geometry, layers, [](const scene::Layer&) { return true; });
    return all.is_empty() ? shown_bounds(geometry, checked) : all.from(geometry.origin);
}

geometry::BoundingBox shown_bounds(const geometry::Geometry& geometry, const scene::CheckedScene& checked) {
    const geometry::BoundingBox whole{geometry.bounds_min, geometry.bounds_max};
    std::vector<const scene::Layer*> shown;
    for (const scene::Layer& layer : checked.scene().layers)
        if (shows_data(layer)) shown.push_back(&layer);
    const bool all_have_thresholds = !shown.empty() && std::all_of(shown.begin(), shown.end(), [](const auto* layer) {
        return has_threshold(*layer);
    });
    if (geometry.clip.empty() && !all_have_thresholds) return whole;
    Box box;
    if (all_have_thresholds) {
        const geometry::ClipPlanes cutter(geometry);
        for (const geometry::Drawable& drawable : geometry.drawables)
            if (std::any_of(shown.begin(), shown.end(), [&](const auto* layer) { return layer->id == drawable.layer; }))
                add_drawable(box, drawable, cutter);
    } else {
        for (const ciel::Vec3d& corner : geometry::corners_of_cut_box(geometry, geometry.clip)) box.add(corner);
    }
    return box.is_empty() ? whole : box.from(geometry.origin);
}

} // namespace server::probe
