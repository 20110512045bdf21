#include "render/surfaces/opaque_depth.hpp"

#include "ciel/types.hpp"
#include "render/target/sheet.hpp"

#include <string>

namespace server::render {

OpaqueDepth::OpaqueDepth(const Gl& gl) : gl_(gl) {
    gl_.GenTextures(1, &texture_);
    gl_.GenTextures(1, &normals_);
    gl_.GenFramebuffers(1, &framebuffer_);
}

void OpaqueDepth::allocate(GLuint texture, GLint format, int width, int height) const {
    const bool is_depth = format == GL_DEPTH_COMPONENT24;
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, is_depth ? GL_DEPTH_COMPONENT : GL_RGBA,
                   is_depth ? GL_UNSIGNED_INT : GL_FLOAT, nullptr);
    filter(gl_, GL_NEAREST);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, is_depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                             texture, 0);
}

void OpaqueDepth::resize(int width, int height, bool with_normals) {
    const bool has_size = width_ == width && height_ == height;
    width_ = 0; // if this call throws, the next call allocates again
    if (!has_size) allocate(texture_, GL_DEPTH_COMPONENT24, width, height);
    if (with_normals) allocate(normals_, GL_RGBA16F, width, height);
    if (!with_normals) gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
    gl_.DrawBuffer(with_normals ? GL_COLOR_ATTACHMENT0 : GL_NONE);
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw ciel::Error("the GL driver cannot draw the depth of a picture of " + std::to_string(width) + " x " +
                          std::to_string(height) + " pixels; ask for a smaller picture");
    width_ = width;
    height_ = height;
    has_normals_ = with_normals;
}

void OpaqueDepth::begin(int width, int height, bool with_normals) {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    if (width_ != width || height_ != height || has_normals_ != with_normals) resize(width, height, with_normals);
    gl_.Viewport(0, 0, width, height);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
}

void OpaqueDepth::go_on() const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.Viewport(0, 0, width_, height_);
}

} // namespace server::render
