// Screen-space ambient occlusion of opaque surfaces, from the depth and normal of each pixel. Finds the horizon along
// some lines through the pixel, and integrates the light above the horizon in closed form. After Jimenez, Wu, Pesce,
// Jarabo: "Practical real-time strategies for accurate indirect occlusion", SIGGRAPH 2016 courses.
// The integral is divided by the integral for an unoccluded plane, which is therefore fully lit at any angle.
// The lines are rotated in a fixed pattern of 4 x 4 pixels, and the result is averaged over 4 x 4 pixels of the same
// surface. Therefore the result has no noise, and does not change from frame to frame.
#pragma once

#include "annotations/camera.hpp"
#include "render/context/shader_program.hpp"
#include "render/frame/frame.hpp"
#include "render/surfaces/opaque_depth.hpp"

namespace server::render {

// The GL objects exist until the GL context is destroyed.
class AmbientOcclusion {
public:
    explicit AmbientOcclusion(const Gl& gl);
    AmbientOcclusion(const AmbientOcclusion&) = delete;
    AmbientOcclusion& operator=(const AmbientOcclusion&) = delete;

    // `opaque` must have the depth and normals of this frame. For a frame with one sample per pixel, light() has half
    // the resolution. Throws Error if the GL cannot draw to this size. Blending must be off. Binds another framebuffer,
    // changes the viewport, and leaves the depth test on.
    void find(const Frame& frame, const annotations::ViewTransform& transform, const OpaqueDepth& opaque);

    // Returns an RG32F texture. R: share of the light that reaches the surface. G: depth / radius. stride(): picture
    // pixels per texel.
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

} // namespace server::render
