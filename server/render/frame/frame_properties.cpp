#include "render/frame/frame_properties.hpp"

namespace server::render {

bool is_transparent(const Primitives& mesh) { return !mesh.lines && mesh.color[3] < 1; }

bool is_opaque(const Primitives& mesh) {
    return !mesh.lines && !mesh.points && !is_transparent(mesh) && !mesh.indices.empty();
}

bool is_opaque_points(const Primitives& mesh) { return mesh.points && !mesh.indices.empty() && mesh.color[3] >= 1; }

bool is_overlay(const Primitives& mesh) { return (mesh.lines || mesh.points) && !mesh.indices.empty(); }

float widest_line(const Frame& frame) {
    float width = 0;
    for (const Primitives& mesh : frame.primitives)
        if (mesh.lines && !mesh.indices.empty()) width = std::max(width, mesh.line_width);
    return width;
}

bool has_transparent_lines(const Frame& frame) {
    return has(frame, [](const Primitives& mesh) { return mesh.lines && mesh.color[3] > 0 && mesh.color[3] < 1; });
}

bool has_transparent_overlays(const Frame& frame) {
    return has(frame,
               [](const Primitives& mesh) { return is_overlay(mesh) && mesh.color[3] > 0 && mesh.color[3] < 1; });
}

bool is_peeled(const Frame& frame) {
    return frame.samples > 1 || !frame.volumes.empty() || has_transparent_overlays(frame);
}

bool has_overlays_in_layers(const Frame& frame) {
    return has_transparent_overlays(frame) ||
           (is_peeled(frame) && has(frame, is_overlay) &&
            has(frame, [](const Primitives& mesh) { return is_transparent(mesh) && mesh.color[3] > 0; }));
}

} // namespace server::render
