#include "render/target/sheet.hpp"

#include "ciel/types.hpp"

#include <string>

namespace server::render {

Sheet::Sheet(const Gl& gl) : gl_(&gl) {
    gl.GenTextures(1, &texture_);
    gl.GenFramebuffers(1, &framebuffer_);
}

void Sheet::size(GLint format, int width, int height) {
    if (width_ == width && height_ == height && format_ == format) return;
    gl_->BindTexture(GL_TEXTURE_2D, texture_);
    gl_->TexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    filter(*gl_, GL_NEAREST);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    width_ = 0; // invalid until the framebuffer is complete
    if (gl_->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw ciel::Error("the GL driver cannot draw volumes and transparent lines in a picture of " +
                          std::to_string(width) + " x " + std::to_string(height) +
                          " pixels; ask for a smaller picture");
    format_ = format;
    width_ = width;
    height_ = height;
}

void Sheet::begin() const {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_->Viewport(0, 0, width_, height_);
}

void filter(const Gl& gl, GLint how) {
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, how);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, how);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void bind(const Gl& gl, int unit, GLuint texture) {
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.ActiveTexture(GL_TEXTURE0);
}

} // namespace server::render
