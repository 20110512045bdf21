// Screen-space ambient occlusion of opaque surfaces, from the depth and normal of each pixel.
// It finds the horizon along some lines through the pixel, and integrates the light above it in closed form.
// After Jimenez, Wu, Pesce, Jarabo: "Practical real-time strategies for accurate indirect occlusion", SIGGRAPH 2016
// courses. The sum is divided by that of an unoccluded plane. So such a plane has exactly all light, at any angle and
// with any number of lines.
//
// 4 x 4 pixels rotate the lines through all angles, in a fixed pattern. The mean of any 4 x 4 pixels of one surface is
// taken. So there is neither noise nor a change from frame to frame.
#pragma once

#include "annotations/camera.hpp"
#include "render/context/shader_program.hpp"
#include "render/frame/frame.hpp"
#include "render/surfaces/opaque_depth.hpp"

namespace ciel::render {

// Its GL objects live as long as their context; textures are reallocated when the size changes.
class AmbientOcclusion {
public:
    explicit AmbientOcclusion(const Gl& gl);
    AmbientOcclusion(const AmbientOcclusion&) = delete;
    AmbientOcclusion& operator=(const AmbientOcclusion&) = delete;

    // Computes light() from `opaque`, which has depth and normals of the frame's size. Frames with one sample use half
    // the resolution, which has the same mean. Throws Error when the GL cannot draw to this size.
    // Needs blending off. Leaves another framebuffer and viewport bound, and depth test on.
    void find(const Frame& frame, const annotations::ViewTransform& transform, const OpaqueDepth& opaque);

    // Input of make_occluded_program() (shaders.hpp). RG32F: share of the light, depth in units of the radius.
    // stride(): picture pixels per texel along a side.
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
    int stride_ = 1, width_ = 0, height_ = 0; // of the sheets
};

} // namespace ciel::render
