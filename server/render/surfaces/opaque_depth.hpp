// The depth of opaque surfaces in the middle of each pixel, and optionally their normals. Drawn separately, because the
// samples of a multisampled picture do not lie in the middles of its pixels.
#pragma once

#include "render/context/gl.hpp"

namespace ciel::render {

// GL objects are freed only with their context. A change of size reallocates the textures under the same GL names.
class OpaqueDepth {
public:
    explicit OpaqueDepth(const Gl& gl);
    OpaqueDepth(const OpaqueDepth&) = delete;
    OpaqueDepth& operator=(const OpaqueDepth&) = delete;

    // Binds and clears the framebuffer. Draws go to it until another framebuffer is bound. Throws Error when the GL
    // cannot draw to this size.
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

} // namespace ciel::render
