// What a frame holds, as to how it is drawn.
#pragma once

#include "render/frame/frame.hpp"

#include <algorithm>

namespace ciel::render {

// While something moves, what is behind so many layers is not waited for.
inline constexpr int most_layers = 32, most_moving_layers = 8;

// Indices of one primitive.
[[nodiscard]] inline std::size_t corners_of(const Primitives& mesh) { return mesh.points ? 1 : mesh.lines ? 2 : 3; }
[[nodiscard]] bool is_transparent(const Primitives& mesh); // triangles or points
[[nodiscard]] bool is_opaque(const Primitives& mesh);      // triangles, and there are some
[[nodiscard]] bool is_overlay(const Primitives& mesh);     // lines or points, and there are some
[[nodiscard]] bool is_opaque_points(const Primitives& mesh);

template <typename Is>
[[nodiscard]] bool has(const Frame& frame, Is is) {
    return std::ranges::any_of(frame.primitives,
                               [&](const Primitives& mesh) { return !mesh.indices.empty() && is(mesh); });
}

[[nodiscard]] float widest_line(const Frame& frame); // 0 without lines
[[nodiscard]] bool has_transparent_lines(const Frame& frame);
[[nodiscard]] bool has_transparent_overlays(const Frame& frame);
// Stills, because triangles that are sorted by their centres show where they cross or enclose each other; where
// surfaces are inside volumes; and lines and points that one can see through: the ones' joints are seen twice else, the
// others have no order.
[[nodiscard]] bool is_peeled(const Frame& frame);
// Where something is peeled, lines and points are among it.
[[nodiscard]] bool has_overlays_in_layers(const Frame& frame);

} // namespace ciel::render
