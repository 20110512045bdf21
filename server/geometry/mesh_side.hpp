// The two sides of a mesh across a plane's normal, at the lowest and the highest distance of its vertices.
#pragma once

#include "ciel/extract.hpp"
#include "store/loaded.hpp"

#include <optional>

namespace ciel::geometry {

// Returns the nu to cut at if a plane at `nu` lies in a side of the mesh within rounding; else nothing. `distances`:
// field of distances along the normal. At the lower end, returns the next larger number: a vertex is high if its value
// is >= nu, so a cut at the end itself would be empty.
[[nodiscard]] std::optional<double> side_at(double nu, const store::ScalarField& distances);

// Returns the boundary's faces in the side at `nu`, a result of side_at. Empty if the mesh ends there in an edge or a
// point.
[[nodiscard]] Surface side_surface(const store::ScalarField& distances, double nu);

} // namespace ciel::geometry
