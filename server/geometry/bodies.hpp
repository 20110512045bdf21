// Which boundary patches are bodies in the flow, and which are the outer sides of the domain.
#pragma once

#include "geometry/scene_geometry.hpp"

#include <span>
#include <string>
#include <vector>

namespace ciel::geometry {

struct Patch {
    std::string name;
    BoundingBox box;
    double area = 0;       // in squared length units
    std::size_t faces = 0; // its cell density: area / faces is the mean size of a face
    std::string type = {}; // that the solver gives it; empty where it is not known
};

// Measures every patch of the mesh that has faces. Reads the points of all of them.
[[nodiscard]] std::vector<Patch> patches_of(const store::Dataset& dataset, const store::Step& step);

// The patches that are bodies: those that lie inside `domain` along two axes at least; and those that do not lie flat
// in one of its sides and have faces of less than a third of the size of the flat ones (a terrain with buildings).
// Where the source gives types, only patches of the type wall are; else those are none whose names say that something
// flows through them, or that they are no surface at all.
[[nodiscard]] std::vector<Patch> bodies_of(std::span<const Patch> patches, const BoundingBox& domain);

// The box around them. REQUIRES: one patch at least.
[[nodiscard]] BoundingBox box_around(std::span<const Patch> patches);

} // namespace ciel::geometry
