// Screen-space ambient occlusion of opaque surfaces, from the depth and normal of each pixel. Finds the horizon along
// some lines through the pixel, and integrates the light above the horizon in closed form. After Jimenez, Wu, Pesce,
// Jarabo: "Practical real-time strategies for accurate indirect occlusion", SIGGRAPH 2016 courses.
// The integral is divided by that of an unoccluded plane. So an unoccluded plane is fully lit, at any angle and with
// any number of lines.
//
// The lines are rotated by an angle that depends on the pixel's place in a fixed pattern of 4 x 4 pixels. The result is
// averaged over 4 x 4 pixels of the same surface. So it has no noise, and does not change from frame to frame.
#pragma once

#include "annotations/camera.hpp"
#include "render/context/shader_program.hpp"
#include "render/frame/frame.hpp"
#include "render/surfaces/opaque_depth.hpp"

namespace ciel::render {

// GL objects are freed only with their context. Textures are reallocated when the size changes.
class AmbientOcclusion {
public:
    explicit AmbientOcclusion(const Gl& gl);
    AmbientOcclusion(const AmbientOcclusion&) = delete;
    AmbientOcclusion& operator=(const AmbientOcclusion&) = delete;

    // Computes light() from `opaque`, which must have depth and normals of the frame's size. Frames with one sample per
    // pixel use half the resolution, which has the same mean brightness. Throws Error when the GL cannot draw to this
    // size.
    // Needs blending off. Leaves another framebuffer and viewport bound, and depth test on.
    void find(const Frame& frame, const annotations::ViewTransform& transform, const OpaqueDepth& opaque);

    // Texture for make_occluded_program() (shaders.hpp), RG32F. R: share of the light that reaches the surface; G:
    // depth in units of the radius. stride(): picture pixels per texel along a side.
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
    int stride_ = 1, width_ = 0, height_ = 0; // picture pixels per texel; texels per side
};

} // namespace ciel::render
