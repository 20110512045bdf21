#include "session/visible_range.hpp"

#include "render/camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>

namespace ciel::session {
namespace {

constexpr int frame_height = 1000; // any: only the shape of the picture counts

bool is_inside(const glm::dmat4& clip_of, const Vec3f& position) {
    const glm::dvec4 clip = clip_of * glm::dvec4(position[0], position[1], position[2], 1);
    return clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
}

} // namespace

std::optional<std::array<double, 2>> visible_range(const Geometry& geometry, const scene::Scene& scene,
                                                   const std::vector<std::string>& layers,
                                                   std::optional<double> aspect) {
    glm::dmat4 clip_of{};
    if (aspect) {
        const int width = std::max(1, static_cast<int>(std::lround(*aspect * frame_height)));
        const auto view = render::view_transform(frame_of(geometry, scene, width, frame_height, 1));
        clip_of = view.projection * view.view;
    }
    double low = INFINITY;
    double high = -INFINITY;
    for (const Drawable& drawable : geometry.drawables) {
        if (!drawable.scalars || std::find(layers.begin(), layers.end(), drawable.layer) == layers.end()) continue;
        const auto& positions = drawable.shape->surface.positions;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const double value = (*drawable.scalars)[i];
            if (!std::isfinite(value) || (value >= low && value <= high)) continue;
            if (aspect && !is_inside(clip_of, positions[i])) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (low > high) return {};
    return std::array{low, high};
}

} // namespace ciel::session
