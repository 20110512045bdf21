// Properties of a frame that decide how it is drawn.
#pragma once

#include "render/frame/frame.hpp"

#include <algorithm>

namespace server::render {

// Largest number of peeled layers; layers behind them are not drawn. most_moving_layers is for frames with one sample
// per pixel that have no volumes or that have transparent points. most_layers is for all other frames.
inline constexpr int most_layers = 32, most_moving_layers = 8;

[[nodiscard]] inline std::size_t corners_of(const Primitives& primitives) {
    return primitives.points ? 1 : primitives.lines ? 2 : 3;
}
[[nodiscard]] bool is_transparent(const Primitives& primitives); // triangles or points of opacity < 1
[[nodiscard]] bool is_opaque(const Primitives& primitives);      // at least one triangle, and opacity 1
[[nodiscard]] bool is_overlay(const Primitives& primitives);     // at least one line or point
[[nodiscard]] bool is_opaque_points(const Primitives& primitives);

template <typename Is>
[[nodiscard]] bool has(const Frame& frame, Is is) {
    return std::ranges::any_of(
        frame.primitives, [&](const Primitives& primitives) { return !primitives.indices.empty() && is(primitives); });
}

[[nodiscard]] float widest_line(const Frame& frame); // width in pixels; 0 without lines
[[nodiscard]] bool has_transparent_lines(const Frame& frame);
[[nodiscard]] bool has_transparent_overlays(const Frame& frame);
// Returns whether the frame needs depth peeling: it has several samples per pixel, volumes, or transparent lines or
// points. Triangles sorted by their centers are in the wrong order where they cross. Without peeling, joints of
// transparent lines would be blended twice, and transparent points would have no order.
[[nodiscard]] bool is_peeled(const Frame& frame);
[[nodiscard]] bool has_overlays_in_layers(const Frame& frame);

} // namespace server::render
