#include "probe/visible_range.hpp"

#include "annotations/camera.hpp"
#include "geometry/viewpoint.hpp"
#include "geometry/volume_cut.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>

namespace server::probe {
namespace {

constexpr int frame_height = 1000; // pixels; arbitrary, because only the aspect is used

// The range of the values at positions that are in view and not clipped. Without an aspect, all positions are used.
class SeenValues {
public:
    SeenValues(const geometry::Geometry& geometry, const scene::CheckedScene& checked, std::optional<double> aspect)
        : geometry_(geometry) {
        if (!aspect) return;
        const int width = std::max(1, static_cast<int>(std::lround(*aspect * frame_height)));
        const auto view = annotations::view_transform(geometry::viewpoint_of(geometry, checked, width, frame_height));
        anywhere_ = false;
        clip_of_ = view.projection * view.view;
    }

    void add(const ciel::Vec3f& position, double value) {
        if (!std::isfinite(value) || (value >= low_ && value <= high_) || !is_seen(position)) return;
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }
    void add(const color::SlabTriangles& mesh, double origin) {
        for (const color::SlabVertex& vertex : mesh.vertices) add(vertex.position, origin + double{vertex.value});
    }
    [[nodiscard]] std::optional<std::array<double, 2>> range() const {
        if (low_ > high_) return {};
        return std::array{low_, high_};
    }

private:
    [[nodiscard]] bool is_seen(const ciel::Vec3f& position) const {
        if (anywhere_) return true;
        for (const ciel::HalfSpace& half : geometry_.clip)
            if (half.normal[0] * position[0] + half.normal[1] * position[1] + half.normal[2] * position[2] +
                    half.offset <
                0)
                return false;
        const glm::dvec4 clip = clip_of_ * glm::dvec4(position[0], position[1], position[2], 1);
        return clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
    }

    const geometry::Geometry& geometry_;
    bool anywhere_ = true;
    glm::dmat4 clip_of_{};
    double low_ = INFINITY, high_ = -INFINITY;
};

} // namespace

std::optional<std::array<double, 2>> visible_range(const geometry::Geometry& geometry,
                                                   const scene::CheckedScene& checked,
                                                   const std::vector<std::string>& layers, std::optional<double> aspect,
                                                   bool of_contours) {
    const auto is_asked = [&](const std::string& layer) { return std::ranges::find(layers, layer) != layers.end(); };
    SeenValues seen(geometry, checked, aspect);
    for (const geometry::Drawable& drawable : geometry.drawables) {
        if (!drawable.scalars || drawable.contours != of_contours || !is_asked(drawable.layer)) continue;
        const auto& positions = drawable.shape->surface.positions;
        for (std::size_t i = 0; i < positions.size(); ++i) seen.add(positions[i], (*drawable.scalars)[i]);
    }
    for (const geometry::VolumeDrawable& volume : geometry.volumes) {
        if (of_contours || !is_asked(volume.layer)) continue;
        seen.add(*volume.slabs->boundary, volume.value_origin);
        for (const color::SlabTriangles& slice : volume.slabs->slices) seen.add(slice, volume.value_origin);
    }
    return seen.range();
}

} // namespace server::probe
