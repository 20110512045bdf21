// Depth peeling of transparent surfaces, and of the lines and points among them. Layers are drawn from front to back.
// At every pixel, a layer has the nearest fragment behind the previous layer. After Everitt, "Interactive
// order-independent transparency", NVIDIA 2001. Each layer is blended with the volumes in front of it.
#pragma once

#include "render/context/shader_program.hpp"
#include "render/surfaces/opaque_depth.hpp"
#include "render/surfaces/shaders.hpp"
#include "render/target/target.hpp"

#include <functional>

namespace server::render {

// Returns whether layers have twice the picture's resolution: with several samples, up to 3840 x 2160 pixels.
[[nodiscard]] bool has_finer_layers(int width, int height, int samples);

// The GL objects exist until the GL context is destroyed.
class DepthPeeling {
public:
    explicit DepthPeeling(const Gl& gl);
    DepthPeeling(const DepthPeeling&) = delete;
    DepthPeeling& operator=(const DepthPeeling&) = delete;

    struct Picture {
        int width = 0, height = 0; // size of the picture in pixels
        int samples = 1;           // samples per pixel of the picture; see has_finer_layers()
        // Draws the transparent lines of a layer again, to join their segments. Must call set_nearer(program, true).
        // Empty if there are no transparent lines.
        std::function<void()> join_lines;
        int most_layers = 32; // layers beyond this count are dropped
        // True: there are many small layers, so volumes are drawn only for the 1st, 2nd, 3rd, 5th, 9th, ... layer.
        bool dense = false;
        // Texture of opaque window depths in the middle of each pixel, for outlines in volumes (per_sample.hpp); or 0.
        GLuint outlines = 0;
        // Draws all opaque surfaces. Only their depth, at the resolution of the layers, is used.
        std::function<void()> draw_opaque;
        // Draws transparent surfaces, and the lines and points among them, with the peeling programs.
        std::function<void()> draw_surfaces;
        // Draws transparent points between two layers from front to back, with the program between(). Empty if there
        // are no transparent points or draw_surfaces draws them.
        std::function<void()> draw_between;
        // Returns a texture (premultiplied RGBA) of the volumes in front of a layer, valid where the layer has colors.
        // For (0, 0), returns a texture of the volumes in front of the opaque surfaces, valid everywhere. Empty if
        // there are no volumes.
        std::function<GLuint(GLuint depth, GLuint color)> volumes;
    };
    // The peeling programs. set_nearer() sets their uniforms for peeling. The caller sets all other uniforms.
    [[nodiscard]] const Program& surfaces() const { return programs().surfaces; }
    [[nodiscard]] const Program& lines() const { return programs().lines; }
    [[nodiscard]] const Program& points() const { return programs().points; }
    // The program of points between layers; `on_surfaces`: the points may lie on surfaces.
    [[nodiscard]] const Program& between(bool on_surfaces) const { return on_surfaces ? between_ : free_between_; }
    // `program`: a peeling program, in use. `joining`: the call is for Picture::join_lines.
    void set_nearer(const Program& program, bool joining) const;
    // Layer pixels per picture pixel along a side; valid in the callbacks of draw().
    [[nodiscard]] int layer_pixels() const { return factor_; }
    // Draws over the opaque surfaces of the target. Leaves depth test and blending on. Throws Error if the GL cannot
    // draw layers of this size. Afterwards was_cut() returns whether visible layers were dropped.
    void draw(const Picture& picture, Target& target);
    [[nodiscard]] bool was_cut() const { return was_cut_; }

private:
    struct Layer { // two Layers alternate: the layer being drawn, and the previous layer
        // record: texture with the last transparent line at each pixel (depth_layers.glsl).
        GLuint framebuffer = 0, depth = 0, record = 0;
    };
    struct Programs {
        Program surfaces, lines, points;
    };
    [[nodiscard]] const Programs& programs() const { return recorded_ ? recorded_programs_ : programs_; }
    void record(bool on);
    void resize(const Picture& picture);
    void allocate(GLuint texture, GLint format, int width, int height) const;
    void attach(GLuint framebuffer, GLuint color, GLuint depth) const;
    [[nodiscard]] GLuint find_opaque(const Picture& picture, Target& target);
    [[nodiscard]] GLuint keep_to_outlines(const Picture& picture);
    [[nodiscard]] bool draw_layer(const Picture& picture, GLuint opaque, const Layer& layer, const Layer& nearer) const;
    void join_lines(const Picture& picture, const Layer& layer) const;
    void begin_sum() const;
    void add_between(const Picture& picture, const Layer& layer) const;
    void add_to_sum(const Layer& layer, GLuint volumes) const;
    void put_on(const Picture& picture, Target& target, GLuint volumes) const;
    void cover() const;

    const Gl& gl_;
    Programs programs_, recorded_programs_;
    Program between_, free_between_;
    ShaderProgram keep_to_outlines_, copy_depth_, add_, picture_, sample_picture_;
    OpaqueDepth fine_opaque_, kept_opaque_;
    Layer layers_[2];
    GLuint color_ = 0, color_framebuffer_ = 0; // colors of the layer being drawn
    GLuint opaque_ = 0, opaque_framebuffer_ = 0;
    GLuint sum_ = 0, sum_framebuffer_ = 0; // RGB: light of the layers so far; alpha: transmittance of these layers
    GLuint nothing_ = 0;                   // transparent picture, used without volumes
    GLuint query_ = 0, no_array_ = 0;
    bool recorded_ = false; // true: the layers of this picture have records of lines
    bool was_cut_ = false;
    int recorded_width_ = 0, recorded_height_ = 0;
    int width_ = 0, height_ = 0, factor_ = 0; // picture pixels; layer pixels per picture pixel along a side
};

} // namespace server::render
