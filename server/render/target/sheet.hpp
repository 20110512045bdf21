// A texture to draw to and to read from.
#pragma once

#include "render/context/gl.hpp"

namespace ciel::render {

// Its GL objects live as long as their context.
class Sheet {
public:
    explicit Sheet(const Gl& gl);

    // Anew behind the same names where the size or format changes. Throws Error when it is more than the GL can do.
    void size(GLint format, int width, int height);
    void begin() const; // binds it for drawing, the whole of it
    [[nodiscard]] GLuint texture() const { return texture_; }

private:
    const Gl* gl_;
    GLuint texture_ = 0, framebuffer_ = 0;
    int width_ = 0, height_ = 0;
    GLint format_ = 0;
};

// Of the texture that is bound.
void filter(const Gl& gl, GLint how);
void bind(const Gl& gl, int unit, GLuint texture);

} // namespace ciel::render
