// The sides of a mesh along a plane's normal: where the first and the last of its vertices lie.
#pragma once

#include "ciel/extract.hpp"
#include "ciel/face_mesh.hpp"
#include "store/loaded.hpp"

#include <optional>

namespace ciel::geometry {

// Where a plane at `nu` cuts if it lies in a side, or off it by no more than rounding. High means value >= nu, so at
// the lower end itself nothing would be cut. `range`: of the distances along the normal.
[[nodiscard]] std::optional<double> side_at(double nu, std::array<float, 2> range);

// The boundary's faces in the side at `nu`, which side_at gave, for a field of distances; none where the mesh ends in
// an edge or a point there.
[[nodiscard]] Surface side_surface(const store::ScalarField& distances, double nu);

} // namespace ciel::geometry
