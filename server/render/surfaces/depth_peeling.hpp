// Transparent surfaces, and lines and points among them, in their order at every pixel, however they cross or enclose
// each other: layer after layer from the eye on, each drawn where it is nearest behind the one before. After Everitt,
// "Interactive order-independent transparency", NVIDIA 2001. A layer's color is what is seen at it through the volume
// in front, so layers and volumes are mixed in their order as well.
#pragma once

#include "render/context/shader_program.hpp"
#include "render/surfaces/opaque_depth.hpp"
#include "render/surfaces/shaders.hpp"
#include "render/target/target.hpp"

#include <functional>

namespace ciel::render {

// Whether the layers of such a picture have twice its resolution.
[[nodiscard]] bool has_finer_layers(int width, int height, int samples);

// Its GL objects live as long as their context; sheets are allocated anew when the size changes.
class DepthPeeling {
public:
    explicit DepthPeeling(const Gl& gl);
    DepthPeeling(const DepthPeeling&) = delete;
    DepthPeeling& operator=(const DepthPeeling&) = delete;

    struct Scene {
        int width = 0, height = 0; // of the picture
        int samples = 1;           // several: layers are drawn at twice the picture's resolution where memory allows
        // Where lines of less than full opacity are among the surfaces: these lines once more, as set_nearer(..., true)
        // says, each of which leaves only what it covers.
        std::function<void()> join_lines;
        int most_layers = 32; // what is behind so many is not seen
        bool dense =
            false; // the layers are many and small: only the 1st, 2nd, 3rd, 5th, 9th ... has volumes drawn for it
        // Window depths in the middle of each pixel, whose outlines are seen through volumes, for per_sample.hpp; or 0.
        GLuint outlines = 0;
        // All that is opaque, for its depth at the layers' resolution.
        std::function<void()> draw_opaque;
        std::function<void()> draw_surfaces; // with the peeling programs in use, lines and points as well
        // Points of less than full opacity, from the nearest on, with such a program in use; empty where there are
        // none, and where they are drawn with the surfaces.
        std::function<void()> draw_between;
        // The picture of the volumes (premultiplied, RGBA) in front of a layer, where it has colors, or of all opaque
        // surfaces for (0, 0); empty where there are none.
        std::function<GLuint(GLuint depth, GLuint color)> volumes;
    };
    // The programs that draw surfaces, lines and points: the caller sets their uniforms.
    [[nodiscard]] const Program& surfaces() const { return programs().surfaces; }
    [[nodiscard]] const Program& lines() const { return programs().lines; }
    [[nodiscard]] const Program& points() const { return programs().points; }
    // And points between layers; `on_surfaces`: there may be some that they lie on.
    [[nodiscard]] const Program& between(bool on_surfaces) const { return on_surfaces ? between_ : free_between_; }
    void set_nearer(const Program& program, bool joining) const; // of one of them, which is in use
    // Pixels of a layer to one of the picture along a side, while draw_surfaces is called.
    [[nodiscard]] int layer_pixels() const { return factor_; }
    // Onto the target, over what is opaque there. Leaves depth test and blending on. Afterwards was_cut() says whether
    // something would be seen behind the last layer.
    void draw(const Scene& scene, Target& target);
    [[nodiscard]] bool was_cut() const { return was_cut_; }

private:
    struct Layer { // one of two that take turns: what is drawn, and what it must be behind
        GLuint framebuffer = 0, depth = 0, record = 0; // as shader_parts.cpp says
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
    GLuint sum_ = 0, sum_framebuffer_ = 0; // light so far, and the share of what is behind that comes through
    GLuint nothing_ = 0;                   // a picture of no volume
    GLuint query_ = 0, no_array_ = 0;
    bool recorded_ = false; // in this picture
    bool was_cut_ = false;
    int recorded_width_ = 0, recorded_height_ = 0;
    int width_ = 0, height_ = 0, factor_ = 0; // of the picture, and layers' pixels per pixel of it along a side
};

} // namespace ciel::render
