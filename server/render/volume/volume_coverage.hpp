// Finds which share of each pixel of a still picture the clipped meshes of volumes cover. Volumes have one ray per
// pixel, so without coverage the outline of a dense volume would have steps.
#pragma once

#include "render/frame/frame.hpp"
#include "render/target/sheet.hpp"
#include "render/volume/volume_rays.hpp"

#include <array>
#include <optional>

namespace server::render {

// The GL objects exist until the GL context is destroyed.
class VolumeCoverage {
public:
    explicit VolumeCoverage(const Gl& gl);
    VolumeCoverage(const VolumeCoverage&) = delete;
    VolumeCoverage& operator=(const VolumeCoverage&) = delete;

    // Throws Error if the GL cannot draw to this size. Binds another framebuffer.
    void begin(const VolumeView& view);
    void add(const VolumeBuffers& buffers) const;
    void finish();
    [[nodiscard]] GLuint texture() const { return shares_.texture(); } // R8: covered share of each pixel

private:
    void allocate(int width, int height, int samples);
    using Planes = std::array<glm::vec4, most_clip_planes>;
    [[nodiscard]] Planes planes_but(std::optional<std::size_t> left_out) const;
    void draw_boundary(const VolumeBuffers& buffers, const Planes& planes) const;
    void draw_cut(const VolumeBuffers& buffers, std::size_t plane) const;
    void draw_facet(const VolumeBuffers& buffers, std::size_t plane) const;

    const Gl& gl_;
    ShaderProgram boundary_program_, facet_program_;
    Sheet shares_;
    GLuint framebuffer_ = 0, samples_buffer_ = 0, depth_buffer_ = 0, no_array_ = 0;
    int width_ = 0, height_ = 0, samples_ = 0;
    VolumeView view_;
};

} // namespace server::render
