#include "render/surfaces/surface_slopes.hpp"

namespace server::render {
namespace {

enum Unit : int { opaque_unit = 4, sheets_unit = 5 }; // texture units that lines and points do not use otherwise

GLuint single_texel(const Gl& gl, float value) {
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 1, 1, 0, GL_RED, GL_FLOAT, &value);
    filter(gl, GL_NEAREST);
    return texture;
}

} // namespace

SurfaceSlopes::SurfaceSlopes(const Gl& gl)
    : gl_(gl), program_(make_slopes_program(gl)), sheets_(gl), far_(single_texel(gl, 1)), flat_(single_texel(gl, 0)) {
    gl_.GenTextures(1, &opaque_);
    gl_.GenFramebuffers(1, &framebuffer_);
    begin();
}

void SurfaceSlopes::begin() {
    opaque_used_ = far_;
    sheets_used_ = flat_;
}

void SurfaceSlopes::copy_opaque(Target& target, int width, int height) {
    if (width_ != width || height_ != height) {
        gl_.BindTexture(GL_TEXTURE_2D, opaque_);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, width, height, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                       nullptr);
        filter(gl_, GL_NEAREST);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, opaque_, 0);
        width_ = width;
        height_ = height;
    }
    target.copy_depth(framebuffer_);
    target.bind_again();
    opaque_used_ = opaque_;
}

void SurfaceSlopes::find_sheets(int width, int height, const std::function<void()>& draw) {
    sheets_.size(GL_RG32F, width, height);
    sheets_.begin();
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_MAX);
    draw();
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.Disable(GL_BLEND);
    gl_.Enable(GL_DEPTH_TEST);
    sheets_used_ = sheets_.texture();
}

void SurfaceSlopes::use(const Program& program) const {
    bind(gl_, opaque_unit, opaque_used_);
    bind(gl_, sheets_unit, sheets_used_);
    gl_.Uniform1i(program.opaque_depth, opaque_unit);
    gl_.Uniform1i(program.sheet_slopes, sheets_unit);
}

} // namespace server::render
