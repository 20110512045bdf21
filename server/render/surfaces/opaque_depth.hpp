// The depth of what is opaque, and its normals for those who want them, in the middle of each pixel. Drawn for itself:
// the picture's own depth has its samples elsewhere.
#pragma once

#include "render/context/gl.hpp"

namespace ciel::render {

// Its GL objects live as long as their context; a change of size allocates anew behind the same names.
class OpaqueDepth {
public:
    explicit OpaqueDepth(const Gl& gl);
    OpaqueDepth(const OpaqueDepth&) = delete;
    OpaqueDepth& operator=(const OpaqueDepth&) = delete;

    // What is drawn until another framebuffer is bound is in it. Throws Error when the size is more than the GL can do.
    void begin(int width, int height, bool with_normals);
    void go_on() const;                                       // the same, to what begin() has bound already
    [[nodiscard]] GLuint texture() const { return texture_; } // GL_DEPTH_COMPONENT24, of the window
    [[nodiscard]] GLuint normals() const { return normals_; } // RGBA16F, where they were asked for

private:
    void allocate(GLuint texture, GLint format, int width, int height) const;
    void resize(int width, int height, bool with_normals);

    const Gl& gl_;
    GLuint texture_ = 0, normals_ = 0, framebuffer_ = 0;
    int width_ = 0, height_ = 0;
    bool has_normals_ = false;
};

} // namespace ciel::render
