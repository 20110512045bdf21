// Depth peeling of transparent surfaces, and of lines and points among them. The order is correct at every pixel, even
// where they cross or enclose each other. Layers are drawn from the eye on, each the nearest behind the previous one.
// After Everitt, "Interactive order-independent transparency", NVIDIA 2001. Each layer is seen through the volumes in
// front of it, so layers and volumes are in order too.
#pragma once

#include "render/context/shader_program.hpp"
#include "render/surfaces/opaque_depth.hpp"
#include "render/surfaces/shaders.hpp"
#include "render/target/target.hpp"

#include <functional>

namespace ciel::render {

// Returns whether layers are drawn at twice the picture's resolution: with several samples, up to 3840 x 2160 pixels.
[[nodiscard]] bool has_finer_layers(int width, int height, int samples);

// Its GL objects live as long as their context; textures are reallocated when the size changes.
class DepthPeeling {
public:
    explicit DepthPeeling(const Gl& gl);
    DepthPeeling(const DepthPeeling&) = delete;
    DepthPeeling& operator=(const DepthPeeling&) = delete;

    struct Scene {
        int width = 0, height = 0; // of the picture
        int samples = 1;           // of the picture; see has_finer_layers()
        // Draws the lines of less than full opacity a second time, with set_nearer(..., true), which joins their
        // segments. Empty without such lines.
        std::function<void()> join_lines;
        int most_layers = 32; // layers beyond this count are dropped
        bool dense = false;   // many small layers: volumes are drawn only for the 1st, 2nd, 3rd, 5th, 9th, ...
        // Opaque window depths at pixel middles, whose outlines are seen through volumes, for per_sample.hpp; or 0.
        GLuint outlines = 0;
        // Draws all opaque surfaces, for their depth at the layers' resolution.
        std::function<void()> draw_opaque;
        std::function<void()> draw_surfaces; // with the peeling programs; lines and points as well
        // Draws points of less than full opacity, front to back, with between(). Empty without such points, or where
        // draw_surfaces draws them.
        std::function<void()> draw_between;
        // Returns a picture (premultiplied RGBA) of the volumes in front of a layer, valid where the layer has colors.
        // For (0, 0): in front of the opaque surfaces, valid everywhere. Empty without volumes.
        std::function<GLuint(GLuint depth, GLuint color)> volumes;
    };
    // The peeling programs. The caller sets their uniforms, and those of peeling by set_nearer().
    [[nodiscard]] const Program& surfaces() const { return programs().surfaces; }
    [[nodiscard]] const Program& lines() const { return programs().lines; }
    [[nodiscard]] const Program& points() const { return programs().points; }
    // The program of points between layers; `on_surfaces`: the points may lie on surfaces.
    [[nodiscard]] const Program& between(bool on_surfaces) const { return on_surfaces ? between_ : free_between_; }
    void set_nearer(const Program& program, bool joining) const; // program: one of these, in use
    // Layer pixels per picture pixel along a side; valid in the callbacks of draw().
    [[nodiscard]] int layer_pixels() const { return factor_; }
    // Draws the layers and volumes onto the target, over its opaque surfaces. Leaves depth test and blending on.
    // Throws Error when the GL cannot draw layers of this size.
    // Afterwards was_cut() returns whether something would be seen behind the last layer.
    void draw(const Scene& scene, Target& target);
    [[nodiscard]] bool was_cut() const { return was_cut_; }

private:
    struct Layer {                                     // two alternate: the layer being drawn, and the nearer one
        GLuint framebuffer = 0, depth = 0, record = 0; // record: of recorded_glsl (shader_parts.cpp)
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
    GLuint color_ = 0, color_framebuffer_ = 0; // of the layer being drawn
    GLuint opaque_ = 0, opaque_framebuffer_ = 0;
    GLuint sum_ = 0, sum_framebuffer_ = 0; // light so far; alpha: transmittance
    GLuint nothing_ = 0;                   // empty picture, used without volumes
    GLuint query_ = 0, no_array_ = 0;
    bool recorded_ = false; // this picture's layers have records
    bool was_cut_ = false;
    int recorded_width_ = 0, recorded_height_ = 0;
    int width_ = 0, height_ = 0, factor_ = 0; // of the picture; layer pixels per picture pixel along a side
};

} // namespace ciel::render
