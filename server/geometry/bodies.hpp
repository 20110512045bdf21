// Finds the boundary patches that are bodies in the flow, not outer sides of the domain.
#pragma once

#include "geometry/scene_geometry.hpp"

#include <span>
#include <string>
#include <vector>

namespace server::geometry {

// A patch of the boundary with its size.
struct MeasuredPatch {
    std::string name;
    BoundingBox box;
    double area = 0;       // in squared length units
    std::size_t faces = 0; // number of faces; area / faces is the mean area of a face
    std::string type = {}; // from the solver; empty if not known
};

// Returns every patch of the mesh that has faces, with its size. Reads all points of these faces.
[[nodiscard]] std::vector<MeasuredPatch> patches_of(const store::Dataset& dataset, const store::Step& step);

// Returns the patches that are bodies: walls that lie inside `domain` along at least two axes. A wall is also a body if
// three conditions hold, as for a terrain with buildings: it is not a flat side of the domain; the edges of its faces
// are shorter than a third of the edges in flat sides; its area is less than 2/3 of the boundary's area.
// If any patch has the type wall or mappedWall, only such patches are walls. Otherwise a patch is a wall unless its
// name says that flow passes through it ("inlet") or that it is not the surface of a body ("interface").
[[nodiscard]] std::vector<MeasuredPatch> bodies_of(std::span<const MeasuredPatch> patches, const BoundingBox& domain);

// Returns the box around all patches. REQUIRES: at least one patch.
[[nodiscard]] BoundingBox box_around(std::span<const MeasuredPatch> patches);

} // namespace server::geometry
