// A color texture with a framebuffer to draw to it.
#pragma once

#include "render/context/gl.hpp"

namespace server::render {

// The GL objects exist until the GL context is destroyed.
class Sheet {
public:
    explicit Sheet(const Gl& gl);

    // Sets format and size. A change keeps the GL name of the texture. Throws Error if the GL cannot draw to this size.
    void size(GLint format, int width, int height);
    void begin() const; // binds the framebuffer, with a viewport of the texture's size
    [[nodiscard]] GLuint texture() const { return texture_; }

private:
    const Gl* gl_;
    GLuint texture_ = 0, framebuffer_ = 0;
    int width_ = 0, height_ = 0;
    GLint format_ = 0;
};

// Sets the minification and magnification filters of the bound 2D texture, and clamps texture coordinates to its edge.
void filter(const Gl& gl, GLint how);
void bind(const Gl& gl, int unit, GLuint texture);

} // namespace server::render
