// A texture to draw to and to read from.
#pragma once

#include "render/context/gl.hpp"

namespace ciel::render {

// Its GL objects live as long as their context.
class Sheet {
public:
    explicit Sheet(const Gl& gl);

    // Reallocates behind the same names if size or format change. Throws Error when the GL cannot draw to this size.
    void size(GLint format, int width, int height);
    void begin() const; // binds it for drawing, with a viewport of its size
    [[nodiscard]] GLuint texture() const { return texture_; }

private:
    const Gl* gl_;
    GLuint texture_ = 0, framebuffer_ = 0;
    int width_ = 0, height_ = 0;
    GLint format_ = 0;
};

// Sets the filter of the bound texture, and clamping to its edge.
void filter(const Gl& gl, GLint how);
void bind(const Gl& gl, int unit, GLuint texture);

} // namespace ciel::render
