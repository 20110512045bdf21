// VolumePictures: cuts a volume into slices and draws it, for benchmarks.
#pragma once

#include "bench/case.hpp"
#include "color/slab_triangles.hpp"
#include "render/renderer.hpp"

namespace server::bench {

// Draws pictures of 1024 x 1024 pixels that show the whole mesh. Use the object on one thread only, because it has an
// OpenGL context. The case must outlive the object.
class VolumePictures {
public:
    static constexpr std::size_t slice_count = 100;
    static constexpr int side = 1024;

    explicit VolumePictures(const Case& data);

    // Cuts new slices perpendicular to `normal`, a unit vector. Returns the number of triangles of all slices.
    std::uint64_t cut(const ciel::Vec3d& normal);
    std::uint64_t cut_across_view() { return cut(view_direction()); }
    // in_bytes: the next pictures blend slices with 8 bits per channel instead of floats (render::Volume::in_bytes).
    void add_up_in_bytes(bool in_bytes) { volume_.in_bytes = in_bytes; }
    // A stride above 1 makes a preview at half the resolution. Returns the number of triangles of the drawn slices.
    std::uint64_t draw(bool shaded, std::size_t stride = 1);
    void turn(double degrees); // turns the camera about its target, around its up vector
    void turn_back();          // sets the default camera

    [[nodiscard]] ciel::Vec3d view_direction() const;
    [[nodiscard]] const render::Frame& frame() const { return frame_; }
    [[nodiscard]] const render::Image& image() const { return image_; }
    [[nodiscard]] const render::Volume& volume() const { return volume_; }
    // The functions below describe the last picture. samples: total area of the drawn slices on the screen, in pixels.
    [[nodiscard]] double covered_share() const;
    [[nodiscard]] double samples() const;

private:
    const Case& data_;
    store::Values values_; // as floats
    std::vector<ciel::Vec3f> gradients_;
    std::vector<std::uint8_t> filled_;
    color::SlabTriangles boundary_;
    std::vector<color::SlabTriangles> slices_;
    render::Volume volume_;
    render::Frame frame_;
    render::Image image_;
    render::Renderer renderer_{render::Backend::automatic};
    std::uint64_t revision_ = 0;
};

// Returns the share of the pixels that are not black, 0 to 1. rgb: three bytes per pixel.
[[nodiscard]] double covered_share(std::span<const std::uint8_t> rgb);

} // namespace server::bench
