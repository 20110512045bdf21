// Input of a picture as values: meshes, volumes, lights and the camera. No GL.
#pragma once

#include "annotations/annotations.hpp"
#include "ciel/types.hpp"
#include "ciel/values_view.hpp"
#include "color/color_scale.hpp"
#include "render/frame/volume.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace ciel::render {

inline constexpr std::size_t most_clip_planes = 6;

// Triangles, lines or points with per-vertex attributes; borrowed for the duration of a draw.
struct Primitives {
    std::span<const Vec3f> positions; // offsets from the frame's origin
    std::span<const Vec3f> normals;   // one per vertex; triangles are counterclockwise around them; empty: flat shading
    ValuesView scalars;               // one per vertex; empty: solid color
    double scalar_origin = 0;         // near the scalars if they are doubles, so that floats relative to it are precise
    std::span<const Index> indices;   // 3 per triangle, 2 per line, 1 per point
    bool lines = false, points = false;
    float line_width = 1.5F, point_size = 4; // pixels
    bool on_opaque = false;  // the lines lie on an opaque surface: slopes of transparent surfaces do not move them
    color::ColorScale scale; // maps the scalars to colors
    std::array<float, 4> color{0.8F, 0.8F, 0.8F, 1}; // alpha is the opacity, also of mapped colors
    std::uint64_t revision = 0;                      // 0: always uploaded; else only when identity or revision change
    std::uint64_t identity = 0;                      // unique number of the drawable that the arrays come from
    bool lit = true;
};

// Strengths of the lights; 0 is off. protocol/shading/lighting.glsl says how they light a surface.
struct Lighting {
    float ambient = 1;   // light from all directions
    float headlight = 1; // light at the eye
    float key_light = 1; // light over the viewer's left shoulder
};

// Darkens lit opaque surfaces where nearby surfaces block the ambient light (ambient_occlusion.hpp).
struct Occlusion {
    double radius = 0; // largest distance at which surfaces shade each other, in world units; 0: off
    float strength = 1;
};

struct Frame : annotations::AnnotatedPicture { // positions of primitives and volumes are offsets from `origin`
    // Drawn in this order: opaque triangles, opaque points, lines, transparent triangles of all meshes sorted back to
    // front. With several samples, volumes, or transparent lines or points, the transparent triangles are peeled
    // instead, with lines and points among the layers (depth_peeling.hpp).
    std::vector<Primitives> primitives;
    // Volumes are drawn in depth order with the primitives; overlapping volumes are mixed. All must have the same
    // normal.
    std::vector<Volume> volumes;
    int samples = 1; // samples per pixel; 4 for stills
    // Clip planes, at most most_clip_planes. Only positions with dot(xyz, position) + w >= 0 for every plane are drawn.
    // pick() finds only these positions.
    std::vector<std::array<float, 4>> clip;
    Lighting lighting;   // lights of `lit` primitives
    Occlusion occlusion; // ambient occlusion of `lit` opaque triangles
    // Called regularly while the picture is drawn, on the drawing thread. May throw to cancel the picture;
    // Renderer::draw passes the exception on.
    std::function<void()> check_wanted;
};

// Picture as RGB with 8 bits per channel, rows from top to bottom, without padding.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

// Stages of a draw call; volumes and annotations are uploaded during `draw`.
enum class DrawStage { upload, draw, read };
using AfterStage = std::function<void(DrawStage)>;

} // namespace ciel::render
