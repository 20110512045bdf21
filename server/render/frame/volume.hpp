// A volume to draw: light emitted and absorbed between the boundary faces of a mesh, in parallel slabs.
#pragma once

#include "ciel/slab.hpp"
#include "color/color_scale.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ciel::render {

// Slab i lies between first + i * thickness and that plus thickness, as measured by dot(normal, position); slice i is
// the cut of its middle plane. Borrowed for the duration of a draw. Meshes wound the wrong way round or with gaps in
// their boundary give a wrong thickness there and nothing worse.
struct Volume {
    std::span<const SlabMesh> slices;   // positions: offsets from the frame's origin
    const SlabMesh* boundary = nullptr; // of all that is filled, wound outwards
    Vec3d normal{0, 0, 1};              // of unit length
    double first = 0, thickness = 1;
    std::size_t stride = 1; // odd: one slice stands for so many slabs

    color::ColorScale scale; // of the property
    // (place between the ends of the range, opacity of a ray that runs one unit length through it); by place.
    std::vector<std::array<double, 2>> opacity_points{{0, 0}, {1, 1}};
    double unit_length = 1;
    bool shaded = true;
    // Of the whole: the picture of all volumes is faded by the largest of theirs, and a volume with less has so much
    // less of its points' opacity.
    float opacity = 1;
    // Resolution of the volumes' picture is that of the frame divided by the largest of this.
    int coarseness = 1;
    // Slabs are added up in bytes instead of floats, where all volumes of the frame ask for it: what the mappers do
    // that benches compare with. Slabs that lose less than half of 1/255 are then lost themselves.
    bool in_bytes = false;
    std::uint64_t identity = 0, revision = 0; // as a mesh's
};

} // namespace ciel::render
