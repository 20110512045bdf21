#include "frames/batches.hpp"

#include "geometry/clip.hpp"
#include "geometry/color_scale_of.hpp"

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

namespace server::frames {

namespace {

// Returns the step to which scalars are rounded. 1/16384 of the color range is invisible, because a color channel has
// only 256 values. Returns 0 (no rounding) for a logarithmic scale, because a step would be visible near zero.
double value_step(const color::ColorScale& scale) {
    constexpr double steps = 16384;
    const double width = scale.range[1] - scale.range[0];
    return scale.log || !(width > 0) || !std::isfinite(width) ? 0 : width / steps;
}

} // namespace

wire::EncodedGeometry geometry_messages(wire::FrameHeader& header, const geometry::Geometry& geometry,
                                        double pixel_ratio, double grid, const wire::HeldArrays& held) {
    using Clock = std::chrono::steady_clock;
    const auto started = Clock::now();
    auto planes = geometry::shader_planes(geometry);
    // A cap is the section of a mesh in a clip plane. Rounding moves the points of a cap by up to one grid step, so the
    // planes are shifted by one step. Otherwise a plane would clip its cap.
    for (auto& plane : planes) plane[3] += static_cast<float>(grid);
    std::vector<wire::Primitives> all;
    for (const geometry::Drawable& drawable : geometry.drawables) {
        const ciel::Surface& surface = drawable.shape->surface;
        wire::Primitives primitives;
        primitives.layer = drawable.layer;
        primitives.positions = surface.positions;
        if (drawable.polygons()) primitives.normals = surface.normals;
        if (drawable.scalars) primitives.scalars = *drawable.scalars;
        primitives.value_step = value_step(drawable.scale);
        primitives.indices = drawable.indices();
        primitives.lines = drawable.lines();
        primitives.points = drawable.points();
        primitives.line_width = drawable.line_width * static_cast<float>(pixel_ratio);
        primitives.map = drawable.scale.map;
        primitives.range = drawable.scale.range;
        primitives.color = drawable.color;
        primitives.lit = drawable.lit;
        primitives.scale = geometry::json_of(drawable.scale).dump();
        primitives.clip = planes;
        all.push_back(std::move(primitives));
    }
    auto encoded = wire::encode_geometry(all, geometry.origin, grid, held);
    auto& messages = encoded.payloads;
    header.encode_ms = std::chrono::duration<float, std::milli>(Clock::now() - started).count();
    const auto common = header.flags;
    for (auto& message : messages) {
        header.flags = common;
        if (&message == &messages.front()) header.flags |= wire::first_of_frame;
        if (&message == &messages.back()) header.flags |= wire::last_of_frame;
        header.payload_bytes = header.whole_bytes = static_cast<std::uint32_t>(message.size());
        std::array<std::uint8_t, wire::frame_header_bytes> bytes{};
        wire::write_frame_header(header, bytes);
        message.insert(message.begin(), bytes.begin(), bytes.end());
    }
    return encoded;
}

ContentKey content_of(const geometry::Geometry& geometry) {
    nlohmann::json key = nlohmann::json::array({geometry.time, geometry.origin, geometry::shader_planes(geometry)});
    for (const geometry::Drawable& drawable : geometry.drawables)
        key.push_back({drawable.layer, drawable.identity, drawable.revision, drawable.scale.map, drawable.scale.range,
                       geometry::json_of(drawable.scale), drawable.color, drawable.line_width});
    return key.dump();
}

} // namespace server::frames
