// How much light from everywhere reaches opaque surfaces, as far as the picture shows what is in its way: from depth
// and normal of every pixel, by the highest thing that is seen from it along some lines through the picture, and the
// light that comes over that in closed form. After Jimenez, Wu, Pesce, Jarabo: "Practical real-time strategies for
// accurate indirect occlusion", SIGGRAPH 2016 courses; the sum is divided by that of a plane without anything on it, so
// that such a plane has exactly all light whatever its angle and however few the lines.
//
// What one pixel lacks in lines its neighbours have: 4 x 4 pixels turn them through all angles, in a pattern that
// stands still, and the mean of any 4 x 4 pixels of one surface is taken. So there is neither noise nor a change from
// frame to frame.
#pragma once

#include "annotations/camera.hpp"
#include "render/context/shader_program.hpp"
#include "render/frame/frame.hpp"
#include "render/surfaces/opaque_depth.hpp"

namespace ciel::render {

// Its GL objects live as long as their context; sheets are allocated anew when the size changes.
class AmbientOcclusion {
public:
    explicit AmbientOcclusion(const Gl& gl);
    AmbientOcclusion(const AmbientOcclusion&) = delete;
    AmbientOcclusion& operator=(const AmbientOcclusion&) = delete;

    // From depth and normals of the frame's size: a pixel for two by two of the picture's where the frame has one
    // sample, which has the same mean. Leaves another framebuffer and viewport bound, depth test on, blending off.
    void find(const Frame& frame, const annotations::ViewTransform& transform, const OpaqueDepth& opaque);

    // For the program of the surfaces (shaders.hpp): RG32F, share of the light and depth in units of the radius; and
    // how many of the picture's pixels one of it stands for along a side.
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
