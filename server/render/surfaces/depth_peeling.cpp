#include "render/surfaces/depth_peeling.hpp"

#include "render/context/pacing.hpp"
#include "render/surfaces/peeling_shaders.hpp"
#include "render/target/per_sample.hpp"
#include "render/target/sheet.hpp"

#include <bit>

namespace server::render {
namespace {

// The layers of such a picture take 1.06 GB: up to 32 bytes per layer pixel, without the records of lines.
constexpr int most_pixels_at_twice_the_resolution = 3840 * 2160;

// Returns whether the volumes are drawn again for this layer. Other layers reuse the picture of the volumes that was
// drawn for an earlier layer. The error is small, because little light of these layers reaches the eye.
bool has_volumes_of_its_own(int layer, bool dense) {
    if (dense) return std::has_single_bit(static_cast<unsigned>(layer)) || layer == 0;
    return layer < 8 || layer % 4 == 0;
}

// The units 0 and 1 are free only in full-screen programs; surface_slopes.cpp uses 4 and 5.
enum Unit : int {
    layer_unit = 0,
    opaque_unit = 1,
    nearer_unit = 2,
    volumes_unit = 3,
    farther_unit = 3,
    lines_unit = 6,
    own_lines_unit = 7,
    behind_unit = 8
};

} // namespace

bool has_finer_layers(int width, int height, int samples) {
    return samples > 1 && width * height <= most_pixels_at_twice_the_resolution;
}

DepthPeeling::DepthPeeling(const Gl& gl)
    : gl_(gl), programs_{make_peeling_program(gl, false), make_peeling_line_program(gl, false),
                         make_peeling_point_program(gl, false)},
      recorded_programs_{make_peeling_program(gl, true), make_peeling_line_program(gl, true),
                         make_peeling_point_program(gl, true)},
      between_(make_point_between_program(gl, true)), free_between_(make_point_between_program(gl, false)),
      keep_to_outlines_(make_kept_to_outlines_program(gl)), copy_depth_(make_depth_copy_program(gl)),
      add_(make_layer_sum_program(gl)), picture_(make_layers_picture_program(gl, false)),
      sample_picture_(make_layers_picture_program(gl, true)), fine_opaque_(gl), kept_opaque_(gl) {
    for (Layer& layer : layers_) {
        gl_.GenFramebuffers(1, &layer.framebuffer);
        gl_.GenTextures(1, &layer.depth);
        gl_.GenTextures(1, &layer.record);
    }
    for (GLuint* texture : {&color_, &opaque_, &sum_, &nothing_}) gl_.GenTextures(1, texture);
    gl_.GenFramebuffers(1, &opaque_framebuffer_);
    gl_.GenFramebuffers(1, &sum_framebuffer_);
    gl_.GenFramebuffers(1, &color_framebuffer_);
    gl_.GenQueries(1, &query_);
    gl_.GenVertexArrays(1, &no_array_);
    constexpr float zeros[4] = {};
    gl_.BindTexture(GL_TEXTURE_2D, nothing_);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, 1, 1, 0, GL_RGBA, GL_FLOAT, zeros);
    filter(gl_, GL_NEAREST);
}

void DepthPeeling::allocate(GLuint texture, GLint format, int width, int height) const {
    const bool is_depth = format != GL_RGBA16F && format != GL_RGBA16;
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, is_depth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_FLOAT,
                   nullptr);
    filter(gl_, texture == sum_ ? GL_LINEAR : GL_NEAREST);
}

void DepthPeeling::attach(GLuint framebuffer, GLuint color, GLuint depth) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    // The status of a framebuffer without color is not checked, because it is only the target of depth copies.
    if (color != 0 && gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw ciel::Error(
            "the GL driver cannot draw transparent surfaces in a picture of this size; ask for a smaller picture");
}

void DepthPeeling::resize(const Picture& picture) {
    const int factor = has_finer_layers(picture.width, picture.height, picture.samples) ? 2 : 1;
    if (width_ == picture.width && height_ == picture.height && factor_ == factor) return;
    factor_ = 0; // if this call throws, the next call allocates again
    width_ = picture.width;
    height_ = picture.height;
    allocate(opaque_, GL_DEPTH_COMPONENT24, width_, height_);
    attach(opaque_framebuffer_, 0, opaque_);
    allocate(color_, GL_RGBA16F, factor * width_, factor * height_);
    attach(color_framebuffer_, color_, 0);
    for (const Layer& layer : layers_) {
        // With 32-bit floats, the stored depth is exactly the depth that the peeling programs compare.
        allocate(layer.depth, GL_DEPTH_COMPONENT32F, factor * width_, factor * height_);
        attach(layer.framebuffer, color_, layer.depth);
    }
    // The format of the sum is RGBA16. With RGBA16F, each of many layers would lose up to a bit of precision.
    allocate(sum_, GL_RGBA16, factor * width_, factor * height_);
    attach(sum_framebuffer_, sum_, 0);
    factor_ = factor;
}

void DepthPeeling::record(bool on) {
    recorded_ = on;
    const int width = factor_ * width_, height = factor_ * height_;
    const bool has_size = recorded_width_ == width && recorded_height_ == height;
    constexpr GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    for (const Layer& layer : layers_) {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer);
        if (on && !has_size) {
            gl_.BindTexture(GL_TEXTURE_2D, layer.record);
            gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, width, height, 0, GL_RG, GL_FLOAT, nullptr);
            filter(gl_, GL_NEAREST);
            gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, layer.record, 0);
        }
        // Detaches the old record, because a smaller attachment would clip all drawing.
        if (!on && recorded_width_ != 0 && !has_size)
            gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, 0, 0);
        gl_.DrawBuffers(on ? 2 : 1, both);
        if (on && gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw ciel::Error(
                "the GL driver cannot draw transparent lines in a picture of this size; ask for a smaller picture");
    }
    if (on || !has_size) {
        recorded_width_ = on ? width : 0;
        recorded_height_ = on ? height : 0;
    }
}

void DepthPeeling::set_nearer(const Program& program, bool joining) const {
    gl_.Uniform1i(program.nearer, nearer_unit);
    gl_.Uniform1i(program.farther, farther_unit);
    gl_.Uniform1i(program.nearer_lines, lines_unit);
    gl_.Uniform1i(program.own_lines, own_lines_unit);
    gl_.Uniform1i(program.behind, behind_unit);
    gl_.Uniform1f(program.joining, joining ? 1.0F : 0.0F);
}

void DepthPeeling::cover() const {
    gl_.BindVertexArray(no_array_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void DepthPeeling::draw(const Picture& picture, Target& target) {
    resize(picture);
    record(static_cast<bool>(picture.join_lines));
    const GLuint opaque = find_opaque(picture, target);
    gl_.Viewport(0, 0, factor_ * width_, factor_ * height_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, sum_framebuffer_);
    gl_.ClearColor(0, 0, 0, 1);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, layers_[1].framebuffer);
    gl_.DepthMask(GL_TRUE);
    gl_.ClearDepth(0);
    gl_.Clear(recorded_ ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : GL_DEPTH_BUFFER_BIT);
    gl_.ClearDepth(1);

    const auto volumes = [&](GLuint depth, GLuint color) {
        return picture.volumes ? picture.volumes(depth, color) : nothing_;
    };
    GLuint in_front = nothing_;
    was_cut_ = false;
    for (int i = 0; i <= picture.most_layers; ++i) {
        const Layer& layer = layers_[i % 2];
        next_pass(gl_);
        const bool any = draw_layer(picture, opaque, layer, layers_[(i + 1) % 2]);
        if (picture.draw_between) add_between(picture, layer);
        if (!any) break;
        was_cut_ = i == picture.most_layers; // this layer is only drawn to find out whether layers are dropped
        if (was_cut_) break;
        if (has_volumes_of_its_own(i, picture.dense)) in_front = volumes(layer.depth, color_);
        add_to_sum(layer, in_front);
    }
    put_on(picture, target, volumes(0, 0));
}

// Returns the opaque depths in the middles of layer pixels. A multisampled target has no samples there.
GLuint DepthPeeling::find_opaque(const Picture& picture, Target& target) {
    if (picture.samples == 1) {
        target.copy_depth(opaque_framebuffer_);
        return opaque_;
    }
    if (factor_ == 1 && picture.outlines != 0) return picture.outlines;
    fine_opaque_.begin(factor_ * width_, factor_ * height_, false);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthMask(GL_TRUE);
    picture.draw_opaque();
    return picture.outlines == 0 ? fine_opaque_.texture() : keep_to_outlines(picture);
}

// Returns opaque depths with all layer pixels of a picture pixel on one side of an outline, for draw_per_sample().
GLuint DepthPeeling::keep_to_outlines(const Picture& picture) {
    kept_opaque_.begin(factor_ * width_, factor_ * height_, false);
    gl_.DepthFunc(GL_ALWAYS);
    bind(gl_, opaque_unit, fine_opaque_.texture());
    bind(gl_, nearer_unit, picture.outlines);
    keep_to_outlines_.use();
    keep_to_outlines_.set("opaque", int{opaque_unit});
    keep_to_outlines_.set("middles", int{nearer_unit});
    cover();
    gl_.DepthFunc(GL_LEQUAL);
    return kept_opaque_.texture();
}

// Draws the layer behind `nearer`. Returns false if this layer is empty.
bool DepthPeeling::draw_layer(const Picture& picture, GLuint opaque, const Layer& layer, const Layer& nearer) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer);
    gl_.Viewport(0, 0, factor_ * width_, factor_ * height_);
    gl_.Disable(GL_BLEND);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthMask(GL_TRUE);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_.DepthFunc(GL_ALWAYS);
    bind(gl_, layer_unit, opaque);
    copy_depth_.use();
    bind(gl_, opaque_unit, sum_);
    copy_depth_.set("opaque", int{layer_unit});
    copy_depth_.set("sum", int{opaque_unit});
    copy_depth_.set("viewport", glm::vec2(factor_ * width_, factor_ * height_));
    cover();
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.DepthFunc(GL_LESS);
    bind(gl_, nearer_unit, nearer.depth);
    if (recorded_) bind(gl_, lines_unit, nearer.record);
    bind(gl_, own_lines_unit, 0); // unbinds the record of this layer, which is attached to the framebuffer
    AnySamples drawn(gl_, query_);
    picture.draw_surfaces();
    const bool any = drawn.passed();
    gl_.DepthFunc(GL_LEQUAL);
    gl_.Enable(GL_BLEND);
    if (any && recorded_) {
        bind(gl_, behind_unit, opaque);
        join_lines(picture, layer);
    }
    return any;
}

void DepthPeeling::join_lines(const Picture& picture, const Layer& layer) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, color_framebuffer_);
    gl_.BlendEquationSeparate(GL_FUNC_ADD, GL_MAX);
    gl_.BlendFuncSeparate(GL_ZERO, GL_ONE, GL_ONE, GL_ONE);
    bind(gl_, own_lines_unit, layer.record);
    picture.join_lines();
    gl_.BlendEquation(GL_FUNC_ADD);
}

void DepthPeeling::begin_sum() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, sum_framebuffer_);
    gl_.Viewport(0, 0, factor_ * width_, factor_ * height_);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.BlendFuncSeparate(GL_DST_ALPHA, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
}

// The depth texture of the previous layer is still bound to nearer_unit.
void DepthPeeling::add_between(const Picture& picture, const Layer& layer) const {
    begin_sum();
    bind(gl_, farther_unit, layer.depth);
    picture.draw_between();
}

void DepthPeeling::add_to_sum(const Layer& layer, GLuint volumes) const {
    begin_sum();
    bind(gl_, layer_unit, color_);
    bind(gl_, volumes_unit, volumes);
    bind(gl_, opaque_unit, layer.depth);
    add_.use();
    add_.set("layer", int{layer_unit});
    add_.set("volumes", int{volumes_unit});
    add_.set("depths", int{opaque_unit});
    add_.set("factor", factor_);
    cover();
}

void DepthPeeling::put_on(const Picture& picture, Target& target, GLuint volumes) const {
    const bool per_sample = picture.samples > 1 && picture.outlines != 0;
    target.bind_again();
    gl_.Disable(GL_DEPTH_TEST);
    gl_.BlendFuncSeparate(GL_ONE, GL_SRC_ALPHA, GL_ZERO, GL_ONE);
    bind(gl_, layer_unit, sum_);
    bind(gl_, volumes_unit, volumes);
    const ShaderProgram& program = per_sample ? sample_picture_ : picture_;
    program.use();
    program.set("sum", int{layer_unit});
    program.set("volumes", int{volumes_unit});
    program.set("viewport", glm::vec2(width_, height_));
    if (per_sample)
        draw_per_sample(gl_, program, {picture.outlines, opaque_unit}, [this] { cover(); });
    else
        cover();
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.Enable(GL_DEPTH_TEST);
}

} // namespace server::render
