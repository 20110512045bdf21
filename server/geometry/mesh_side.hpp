// The two sides of a mesh across a plane's normal, at the lowest and the highest distance of its vertices.
#pragma once

#include "ciel/extract.hpp"
#include "store/loaded.hpp"

#include <optional>

namespace server::geometry {

// Returns the value at which the mesh must be cut if the plane at `nu` lies in a side of the mesh, up to rounding; else
// nothing. `distances`: field of distances along the normal. At the lower side, the result is the next number above the
// least distance. A vertex is high if its value is >= nu, so a cut at the least distance itself would be empty.
[[nodiscard]] std::optional<double> side_at(double nu, const store::ScalarField& distances);

// Returns the boundary faces in the side of the mesh at `nu`, a result of side_at. The surface is empty if the mesh
// ends at `nu` in an edge or a point.
[[nodiscard]] ciel::Surface side_surface(const store::ScalarField& distances, double nu);

} // namespace server::geometry
