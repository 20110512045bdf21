// The input of a picture: primitives, volumes, lights and the camera. Does not depend on OpenGL.
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

namespace server::render {

inline constexpr std::size_t most_clip_planes = 6;

// Does not own the arrays, which must exist until the draw call returns.
struct Primitives {
    std::span<const ciel::Vec3f> positions; // offsets from the frame's origin
    // One per vertex; empty: flat shading. Normals point to the side from which the triangle is counterclockwise.
    std::span<const ciel::Vec3f> normals;
    ciel::ValuesView scalars; // one per vertex; empty: solid color
    // A number near the scalars. Before doubles are uploaded as floats, this number is subtracted, so that they keep
    // their digits.
    double scalar_origin = 0;
    std::span<const ciel::Index> indices; // 3 per triangle, 2 per line, 1 per point
    bool lines = false, points = false;
    float line_width = 1.5F, point_size = 4; // pixels
    // True: the lines lie on an opaque surface, so transparent surfaces do not move them (surface_slopes.hpp).
    bool on_opaque = false;
    color::ColorScale scale;
    // RGB of a solid color; alpha is the opacity, also of mapped colors.
    std::array<float, 4> color{0.8F, 0.8F, 0.8F, 1};
    // 0: the arrays are uploaded for every frame. Otherwise they are uploaded only if identity or revision has changed.
    std::uint64_t revision = 0;
    std::uint64_t identity = 0; // unique number of the object that owns these arrays
    bool lit = true;
};

// Strengths of the lights; 0 switches a light off. protocol/shading/lighting.glsl defines how they light a surface.
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
    // Drawing order: opaque triangles, opaque points, lines, then transparent triangles from back to front. If the
    // frame has several samples per pixel, volumes, transparent lines or transparent points, depth peeling draws the
    // transparent triangles instead (depth_peeling.hpp). The peeled layers may then also contain lines and points.
    std::vector<Primitives> primitives;
    // Overlapping volumes are blended slab by slab. All volumes must have the same normal.
    std::vector<Volume> volumes;
    int samples = 1; // samples per pixel; usually 4 in still pictures
    // Clip planes (xyz, w), at most most_clip_planes. Only positions with dot(xyz, position) + w >= 0 for every plane
    // are drawn and found by pick().
    std::vector<std::array<float, 4>> clip;
    Lighting lighting;   // lights of `lit` primitives
    Occlusion occlusion; // ambient occlusion of `lit` opaque triangles
    // Called regularly on the drawing thread. May throw to cancel the picture; Renderer::draw propagates the exception.
    std::function<void()> check_wanted;
};

// A picture: RGB with 8 bits per channel, rows from top to bottom, without padding.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

// Stages of a draw call. The stage `draw` also uploads volumes and annotations.
enum class DrawStage { upload, draw, read };
using AfterStage = std::function<void(DrawStage)>;

} // namespace server::render
