// Depth peeling of transparent surfaces, and of lines and points among them. The order is correct at every pixel, even
// where surfaces cross or enclose each other. Layers are drawn from front to back. Each has, at every pixel, the
// nearest fragment behind the previous layer. After Everitt, "Interactive order-independent transparency", NVIDIA 2001.
// Each layer is blended with the volumes in front of it, so layers and volumes are in depth order, too.
#pragma once

#include "render/context/shader_program.hpp"
#include "render/surfaces/opaque_depth.hpp"
#include "render/surfaces/shaders.hpp"
#include "render/target/target.hpp"

#include <functional>

namespace ciel::render {

// Returns whether layers are drawn at twice the picture's resolution: with several samples, up to 3840 x 2160 pixels.
[[nodiscard]] bool has_finer_layers(int width, int height, int samples);

// GL objects are freed only with their context. Textures are reallocated when the size changes.
class DepthPeeling {
public:
    explicit DepthPeeling(const Gl& gl);
    DepthPeeling(const DepthPeeling&) = delete;
    DepthPeeling& operator=(const DepthPeeling&) = delete;

    struct Scene {
        int width = 0, height = 0; // of the picture, in pixels
        int samples = 1;           // per pixel of the picture; see has_finer_layers()
        // Draws the transparent lines a second time, with set_nearer(..., true), which joins their segments. Empty
        // without transparent lines.
        std::function<void()> join_lines;
        int most_layers = 32; // layers beyond this count are dropped
        bool dense = false;   // many small layers: volumes are drawn only for the 1st, 2nd, 3rd, 5th, 9th, ... layer
        // Texture of opaque window depths at pixel middles, if outlines of opaque surfaces are visible through volumes
        // (per_sample.hpp); otherwise 0.
        GLuint outlines = 0;
        // Draws all opaque surfaces, for their depth at the layers' resolution.
        std::function<void()> draw_opaque;
        // Draws transparent surfaces, and the lines and points among them, with the peeling programs.
        std::function<void()> draw_surfaces;
        // Draws the transparent points, front to back, with between(). Empty without transparent points, or if
        // draw_surfaces draws them.
        std::function<void()> draw_between;
        // Returns a picture (premultiplied RGBA) of the volumes in front of a layer, valid where the layer has colors.
        // For (0, 0): of the volumes in front of the opaque surfaces, valid everywhere. Empty without volumes.
        std::function<GLuint(GLuint depth, GLuint color)> volumes;
    };
    // The peeling programs. The caller sets their uniforms; set_nearer() sets those of peeling.
    [[nodiscard]] const Program& surfaces() const { return programs().surfaces; }
    [[nodiscard]] const Program& lines() const { return programs().lines; }
    [[nodiscard]] const Program& points() const { return programs().points; }
    // The program of points between layers; `on_surfaces`: the points may lie on surfaces.
    [[nodiscard]] const Program& between(bool on_surfaces) const { return on_surfaces ? between_ : free_between_; }
    void set_nearer(const Program& program, bool joining) const; // `program`: a peeling program, in use
    // Layer pixels per picture pixel along a side; valid in the callbacks of draw().
    [[nodiscard]] int layer_pixels() const { return factor_; }
    // Draws the layers and volumes onto the target, over its opaque surfaces. Leaves depth test and blending on. Throws
    // Error when the GL cannot draw layers of this size.
    // Afterwards was_cut() returns whether visible layers were dropped.
    void draw(const Scene& scene, Target& target);
    [[nodiscard]] bool was_cut() const { return was_cut_; }

private:
    struct Layer { // two Layers alternate: the one being drawn, and the nearer one
        // record: texture of the last line at each pixel (recorded_glsl in shader_parts.cpp).
        GLuint framebuffer = 0, depth = 0, record = 0;
    };
    struct Programs {
        Program surfaces, lines, points;
    };
    [[nodiscard]] const Programs& programs() const { return recorded_ ? recorded_programs_ : programs_; }
    void record(bool on);
    void resize(const Scene& scene);
    void allocate(GLuint texture, GLint format, int width, int height) const;
    void attach(GLuint framebuffer, GLuint color, GLuint depth) const;
    [[nodiscard]] GLuint find_opaque(const Scene& scene, Target& target);
    [[nodiscard]] GLuint keep_to_outlines(const Scene& scene);
    [[nodiscard]] bool draw_layer(const Scene& scene, GLuint opaque, const Layer& layer, const Layer& nearer) const;
    void join_lines(const Scene& scene, const Layer& layer) const;
    void begin_sum() const;
    void add_between(const Scene& scene, const Layer& layer) const;
    void add_to_sum(const Layer& layer, GLuint volumes) const;
    void put_on(const Scene& scene, Target& target, GLuint volumes) const;
    void cover() const;

    const Gl& gl_;
    Programs programs_, recorded_programs_;
    Program between_, free_between_;
    ShaderProgram keep_to_outlines_, copy_depth_, add_, picture_, sample_picture_;
    OpaqueDepth fine_opaque_, kept_opaque_;
    Layer layers_[2];
    GLuint color_ = 0, color_framebuffer_ = 0; // colors of the layer being drawn
    GLuint opaque_ = 0, opaque_framebuffer_ = 0;
    GLuint sum_ = 0, sum_framebuffer_ = 0; // light of the layers so far; alpha: their transmittance
    GLuint nothing_ = 0;                   // transparent picture, used without volumes
    GLuint query_ = 0, no_array_ = 0;
    bool recorded_ = false; // layers of this picture have records of lines
    bool was_cut_ = false;
    int recorded_width_ = 0, recorded_height_ = 0;
    int width_ = 0, height_ = 0, factor_ = 0; // picture pixels; layer pixels per picture pixel along a side
};

} // namespace ciel::render
