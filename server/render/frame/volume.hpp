// A volume to draw: light emitted and absorbed between the boundary faces of a mesh, in parallel slabs.
#pragma once

#include "ciel/slab.hpp"
#include "color/color_scale.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ciel::render {

// Slab i begins at dot(normal, position) = first + i * thickness; slice i is the cut by its middle plane. Borrowed for
// the duration of a draw. Where the boundary has gaps or the wrong winding, only the thickness is wrong.
struct Volume {
    std::span<const SlabMesh> slices;   // positions: offsets from the frame's origin
    const SlabMesh* boundary = nullptr; // of the filled region, wound outwards
    Vec3d normal{0, 0, 1};              // of unit length
    double first = 0, thickness = 1;
    std::size_t stride = 1; // odd: number of slabs per slice drawn

    color::ColorScale scale; // of the property
    // (place between the ends of the range, opacity of one unit length along a ray); sorted by place.
    std::vector<std::array<double, 2>> opacity_points{{0, 0}, {1, 1}};
    double unit_length = 1;
    bool shaded = true;
    // Of the whole volume. The picture of all volumes is multiplied by the largest one. The opacity points of each
    // volume are multiplied by its ratio to the largest.
    float opacity = 1;
    // The largest one divides the resolution of the volumes' picture.
    int coarseness = 1;
    // Blends slabs in bytes instead of floats, if all volumes of the frame ask for it, as the mappers in benchmarks do.
    // Slabs that absorb less than half of 1/255 then have no effect.
    bool in_bytes = false;
    std::uint64_t identity = 0, revision = 0; // as of Primitives
};

} // namespace ciel::render
