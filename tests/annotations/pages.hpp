// Frames with all annotations, for the tests of their layout and look.
#pragma once

#include "render/scenes.hpp"

namespace ciel::render {

inline Annotations all_annotations() {
    Annotations annotations;
    annotations.title = "Wake of a sphere at Re 300 — ν = 1.5 µm²/s";
    annotations.captions = {"sphere_polyhedra", "Time: 0.35"};
    annotations.legends = {{"U:magnitude", "m/s", "viridis", {0, 1.4327}},
                           {"p", "m^2/s^2", "coolwarm", {-0.61, 0.52}},
                           {"T", "°C", "inferno", {1.2e-5, 3.4e-5}}};
    annotations.triad = true;
    annotations.axes = true;
    annotations.length_units = "m";
    return annotations;
}

// A camera from which three faces of the box are seen.
inline Frame annotated_frame(int width, int height) {
    Frame frame = front_view(width, height);
    frame.bounds_min = {-1, -1, -1};
    frame.bounds_max = {3, 1, 1};
    frame.camera = default_camera({-2, -2, -2}, {4, 2, 2}, static_cast<double>(width) / height);
    frame.annotations = all_annotations();
    return frame;
}

} // namespace ciel::render
