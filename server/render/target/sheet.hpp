// A color texture with a framebuffer to draw to it.
#pragma once

#include "render/context/gl.hpp"

namespace ciel::render {

// GL objects of a Sheet are freed only with their context.
class Sheet {
public:
    explicit Sheet(const Gl& gl);

    // Reallocates the texture under the same GL name if size or format change. Throws Error when the GL cannot draw to
    // this size.
    void size(GLint format, int width, int height);
    void begin() const; // binds the framebuffer, with a viewport of the texture's size
    [[nodiscard]] GLuint texture() const { return texture_; }

private:
    const Gl* gl_;
    GLuint texture_ = 0, framebuffer_ = 0;
    int width_ = 0, height_ = 0;
    GLint format_ = 0;
};

// Sets both filters of the bound 2D texture, and clamping to its edge.
void filter(const Gl& gl, GLint how);
void bind(const Gl& gl, int unit, GLuint texture);

} // namespace ciel::render
