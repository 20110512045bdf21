// What share of each pixel is covered by the mesh of volumes, in a still: where a volume is all but opaque at once, its
// outline would have steps, for it has one ray per pixel.
#pragma once

#include "render/shader_program.hpp"
#include "render/sheet.hpp"
#include "render/volume/volume_buffers.hpp"

namespace ciel::render {

// Its GL objects live as long as their context.
class VolumeCoverage {
public:
    explicit VolumeCoverage(const Gl& gl);
    VolumeCoverage(const VolumeCoverage&) = delete;
    VolumeCoverage& operator=(const VolumeCoverage&) = delete;

    // Throws Error when the size is more than the GL can do. Leaves another framebuffer bound.
    void begin(int width, int height, int samples);
    void add(const VolumeBuffers& buffers, const glm::mat4& transform) const;
    void finish();
    [[nodiscard]] GLuint texture() const { return shares_.texture(); } // R8

private:
    const Gl& gl_;
    ShaderProgram program_;
    Sheet shares_;
    GLuint framebuffer_ = 0, samples_buffer_ = 0;
    int width_ = 0, height_ = 0, samples_ = 0;
};

} // namespace ciel::render
