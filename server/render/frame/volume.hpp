// A volume to draw: the space inside a mesh, which emits and absorbs light. It is divided into parallel slabs.
#pragma once

#include "color/color_scale.hpp"
#include "color/slab_triangles.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace server::render {

// Slab i begins at dot(normal, position) = first + i * thickness. Slice i is the cut of the mesh by the middle plane of
// slab i. Does not own slices and boundary, which must exist until the draw call returns. If the boundary has gaps or
// the wrong winding, the volume looks too thick or too thin there.
struct Volume {
    std::span<const color::SlabTriangles> slices;   // positions: offsets from the frame's origin
    const color::SlabTriangles* boundary = nullptr; // faces around the mesh, counterclockwise seen from outside
    ciel::Vec3d normal{0, 0, 1};                    // unit vector across the slabs
    double first = 0, thickness = 1;
    std::size_t stride = 1; // odd; only every stride-th slice is drawn, and each drawn slab is thicker by this factor

    color::ColorScale scale; // maps the property to colors
    // Pairs (position in the scale's range, from 0 to 1; opacity per unit_length of a ray), sorted by position.
    std::vector<std::array<double, 2>> opacity_points{{0, 0}, {1, 1}};
    double unit_length = 1;
    bool shaded = true;
    // Opacity of the whole volume. The picture of all volumes is multiplied by the largest `opacity` of them, and the
    // opacity points of each volume by its `opacity` divided by the largest.
    float opacity = 1;
    // Picture pixels per ray along a side. All volumes use the largest coarseness among them.
    int coarseness = 1;
    // For benchmarks: blends with 8 bits per channel if in_bytes is true for all volumes of the frame. Slabs that
    // absorb less than half of 1/255 then have no effect.
    bool in_bytes = false;
    std::uint64_t identity = 0, revision = 0; // as in Primitives
};

} // namespace server::render
