// A volume to draw: light emitted and absorbed between the boundary faces of a mesh, in parallel slabs.
#pragma once

#include "ciel/slab.hpp"
#include "color/color_scale.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ciel::render {

// Slab i begins at dot(normal, position) = first + i * thickness. Slice i is the mesh cut by the middle plane of slab
// i. Slices and boundary are borrowed for the duration of a draw. Where the boundary has gaps or the wrong winding, the
// volume only looks too thick or too thin.
struct Volume {
    std::span<const SlabMesh> slices;   // positions: offsets from the frame's origin
    const SlabMesh* boundary = nullptr; // faces around the mesh, wound outwards
    Vec3d normal{0, 0, 1};              // unit vector across the slabs
    double first = 0, thickness = 1;
    std::size_t stride = 1; // odd; only every stride-th slice is drawn, for a slab thicker by this factor

    color::ColorScale scale; // maps the property to colors
    // (place in the scale's range, from 0 to 1; opacity of a stretch of unit_length along a ray); sorted by place.
    std::vector<std::array<double, 2>> opacity_points{{0, 0}, {1, 1}};
    double unit_length = 1;
    bool shaded = true;
    // Opacity of the whole volume. The picture of all volumes is multiplied by the largest `opacity`. The opacity
    // points of each volume are multiplied by the ratio of its `opacity` to the largest one.
    float opacity = 1;
    // Picture pixels per ray along a side. The largest coarseness of all volumes counts.
    int coarseness = 1;
    // Blends slabs in 8 bits per channel instead of floats, if all volumes of the frame ask for it. For comparisons in
    // benchmarks. Slabs that absorb less than half of 1/255 then have no effect.
    bool in_bytes = false;
    std::uint64_t identity = 0, revision = 0; // as in Primitives
};

} // namespace ciel::render
