#include "render/frame/frame_properties.hpp"

namespace server::render {

bool is_transparent(const Primitives& primitives) { return !primitives.lines && primitives.color[3] < 1; }

bool is_opaque(const Primitives& primitives) {
    return !primitives.lines && !primitives.points && !is_transparent(primitives) && !primitives.indices.empty();
}

bool is_opaque_points(const Primitives& primitives) {
    return primitives.points && !primitives.indices.empty() && primitives.color[3] >= 1;
}

bool is_overlay(const Primitives& primitives) {
    return (primitives.lines || primitives.points) && !primitives.indices.empty();
}

float widest_line(const Frame& frame) {
    float width = 0;
    for (const Primitives& primitives : frame.primitives)
        if (primitives.lines && !primitives.indices.empty()) width = std::max(width, primitives.line_width);
    return width;
}

bool has_transparent_lines(const Frame& frame) {
    return has(frame, [](const Primitives& primitives) {
        return primitives.lines && primitives.color[3] > 0 && primitives.color[3] < 1;
    });
}

bool has_transparent_overlays(const Frame& frame) {
    return has(frame, [](const Primitives& primitives) {
        return is_overlay(primitives) && primitives.color[3] > 0 && primitives.color[3] < 1;
    });
}

bool is_peeled(const Frame& frame) {
    return frame.samples > 1 || !frame.volumes.empty() || has_transparent_overlays(frame);
}

bool has_overlays_in_layers(const Frame& frame) {
    return has_transparent_overlays(frame) ||
           (is_peeled(frame) && has(frame, is_overlay) && has(frame, [](const Primitives& primitives) {
                return is_transparent(primitives) && primitives.color[3] > 0;
            }));
}

} // namespace server::render
