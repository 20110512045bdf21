// A volume cut into slices and drawn, as often as somebody measures it.
#pragma once

#include "bench/case.hpp"
#include "ciel/slab.hpp"
#include "render/renderer.hpp"

namespace ciel::bench {

// Of 1024 x 1024 pixels, with the whole mesh in it. To be used on one thread, which its GL belongs to.
class VolumePictures {
public:
    static constexpr std::size_t slice_count = 100;
    static constexpr int side = 1024;

    explicit VolumePictures(const Case& data);

    // Cuts the slices anew, across a direction of unit length; returns their triangles.
    std::uint64_t cut(const Vec3d& normal);
    std::uint64_t cut_across_view() { return cut(view_direction()); }
    // Slabs of the next pictures are added up in bytes, as render::Volume has it.
    void add_up_in_bytes(bool in_bytes) { volume_.in_bytes = in_bytes; }
    // stride: one slice in so many; more than 1 as a preview, which has half the resolution. Returns the triangles of
    // those that are drawn. The picture is multisampled where others in it would be.
    std::uint64_t draw(bool shaded, std::size_t stride = 1);
    void turn(double degrees); // the camera about the middle of the mesh, around its up
    void turn_back();          // to where it was first

    [[nodiscard]] Vec3d view_direction() const;
    [[nodiscard]] const render::Frame& frame() const { return frame_; }
    [[nodiscard]] const render::Image& image() const { return image_; }
    [[nodiscard]] const render::Volume& volume() const { return volume_; }
    // Of the last picture: the share of its pixels that the volume changed, from 0 to 1, and the pixels of all slices.
    [[nodiscard]] double covered_share() const;
    [[nodiscard]] double samples() const;

private:
    const Case& data_;
    std::vector<Vec3f> gradients_;
    std::vector<std::array<float, 2>> limits_;
    SlabMesh boundary_;
    std::vector<SlabMesh> slices_;
    render::Volume volume_;
    render::Frame frame_;
    render::Image image_;
    render::Renderer renderer_{render::Backend::automatic};
    std::uint64_t revision_ = 0;
};

// Of a picture on black: the share of the pixels that are not.
[[nodiscard]] double covered_share(std::span<const std::uint8_t> rgb);

} // namespace ciel::bench
