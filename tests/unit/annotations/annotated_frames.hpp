// Frames with every kind of annotation, for layout and legibility tests.
#pragma once

#include "unit/render/scenes.hpp"

namespace server::annotations {

inline color::ColorScale scale_of(const std::string& map, const std::array<double, 2>& range) {
    color::ColorScale scale;
    scale.map = map;
    scale.range = range;
    return scale;
}

inline annotations::Annotations all_annotations() {
    annotations::Annotations annotations;
    annotations.title = "Wake of a sphere at Re 300 — ν = 1.5 µm²/s";
    annotations.captions = {"sphere_polyhedra", "Time: 0.35"};
    annotations.legends = {{"U:magnitude", "m/s", scale_of("viridis", {0, 1.4327F})},
                           {"p", "m^2/s^2", scale_of("coolwarm", {-0.61F, 0.52F})},
                           {"T", "°C", scale_of("inferno", {1.2e-5F, 3.4e-5F})}};
    annotations.triad = true;
    annotations.axes = true;
    annotations.length_units = "m";
    return annotations;
}

// The camera shows three faces of the box.
inline render::Frame annotated_frame(int width, int height) {
    render::Frame frame = render::front_view(width, height);
    frame.bounds_min = {-1, -1, -1};
    frame.bounds_max = {3, 1, 1};
    frame.camera = annotations::default_camera({-2, -2, -2}, {4, 2, 2}, static_cast<double>(width) / height);
    frame.annotations = all_annotations();
    return frame;
}

} // namespace server::annotations
