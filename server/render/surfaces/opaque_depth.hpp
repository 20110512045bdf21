// Textures of the depth of opaque surfaces in the middle of each pixel, and optionally of the normals of these
// surfaces. They are drawn in a pass of their own, because the samples of a multisampled picture are not in the middle
// of its pixels.
#pragma once

#include "render/context/gl.hpp"

namespace server::render {

// The GL objects exist until the GL context is destroyed. A change of size keeps their names.
class OpaqueDepth {
public:
    explicit OpaqueDepth(const Gl& gl);
    OpaqueDepth(const OpaqueDepth&) = delete;
    OpaqueDepth& operator=(const OpaqueDepth&) = delete;

    // Binds a framebuffer with cleared depth, to which the caller draws. Throws Error if the GL cannot draw this size.
    void begin(int width, int height, bool with_normals);
    void go_on() const;                                       // binds the framebuffer again without clearing
    [[nodiscard]] GLuint texture() const { return texture_; } // window depths, GL_DEPTH_COMPONENT24
    [[nodiscard]] GLuint normals() const { return normals_; } // RGBA16F; valid after begin() with normals

private:
    void allocate(GLuint texture, GLint format, int width, int height) const;
    void resize(int width, int height, bool with_normals);

    const Gl& gl_;
    GLuint texture_ = 0, normals_ = 0, framebuffer_ = 0;
    int width_ = 0, height_ = 0;
    bool has_normals_ = false;
};

} // namespace server::render
