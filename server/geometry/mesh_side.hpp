// The two sides of a mesh along a plane's normal: at its first and last vertices.
#pragma once

#include "ciel/extract.hpp"
#include "store/loaded.hpp"

#include <optional>

namespace ciel::geometry {

// Returns the nu to cut at if a plane at `nu` lies in a side of the mesh within rounding; else nothing. `distances`:
// field of distances along the normal. At the lower end it returns the next number above: high means value >= nu, so
// the end itself would cut nothing.
[[nodiscard]] std::optional<double> side_at(double nu, const store::ScalarField& distances);

// Returns the boundary's faces in the side at `nu`, a result of side_at. Empty if the mesh ends there in an edge or a
// point.
[[nodiscard]] Surface side_surface(const store::ScalarField& distances, double nu);

} // namespace ciel::geometry
