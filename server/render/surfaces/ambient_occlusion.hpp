// Screen-space ambient occlusion of opaque surfaces, from the depth and normal of each pixel. Finds the horizon along
// some lines through the pixel, and integrates the light above the horizon in closed form. After Jimenez, Wu, Pesce,
// Jarabo: "Practical real-time strategies for accurate indirect occlusion", SIGGRAPH 2016 courses.
// The integral is divided by the integral for an unoccluded plane. Therefore an unoccluded plane is fully lit, at any
// angle and with any number of lines.
//
// The lines are rotated by an angle that depends on the pixel's position in a fixed pattern of 4 x 4 pixels. The result
// is averaged over 4 x 4 pixels of the same surface. Therefore the result has no noise, and does not change from frame
// to frame.
#pragma once

#include "annotations/camera.hpp"
#include "render/context/shader_program.hpp"
#include "render/frame/frame.hpp"
#include "render/surfaces/opaque_depth.hpp"

namespace ciel::render {

// The destructor does not delete the GL objects. They exist until the GL context is destroyed. A change of size
// reallocates the textures.
class AmbientOcclusion {
public:
    explicit AmbientOcclusion(const Gl& gl);
    AmbientOcclusion(const AmbientOcclusion&) = delete;
    AmbientOcclusion& operator=(const AmbientOcclusion&) = delete;

    // Computes the texture light(). `opaque` must have the depth and normals of this frame, at the frame's size. For a
    // frame with one sample per pixel, the texture has half the resolution and the same mean brightness. Throws Error
    // if the GL cannot draw to this size.
    // Blending must be off. Binds another framebuffer, changes the viewport, and leaves the depth test on.
    void find(const Frame& frame, const annotations::ViewTransform& transform, const OpaqueDepth& opaque);

    // Texture for make_occluded_program() (shaders.hpp), RG32F. R: share of the light that reaches the surface. G:
    // depth in units of the radius. stride() returns the number of picture pixels per texel along a side.
    [[nodiscard]] GLuint light() const { return even_.texture; }
    [[nodiscard]] int stride() const { return stride_; }

private:
    struct Sheet {
        GLuint texture = 0, framebuffer = 0;
    };
    void resize(int width, int height);
    void allocate(const Sheet& sheet, GLint format) const;
    void cover(const Sheet& sheet) const;

    const Gl& gl_;
    ShaderProgram find_, even_out_;
    Sheet found_, even_;
    GLuint no_array_ = 0;
    int stride_ = 1, width_ = 0, height_ = 0; // picture pixels per texel along a side; size of the textures
};

} // namespace ciel::render
