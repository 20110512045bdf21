// The caller's values in the order of the stored mesh. Not in the paper.
#pragma once

#include "ciel/mesh.hpp"

#include <vector>

namespace ciel {

enum class PerItem { point, cell };

// values: one number per point or cell of the caller's. Throws Error on another number of rows or columns.
[[nodiscard]] std::vector<float> stored_values(const Mesh& mesh, const ArrayView& values, PerItem item);

} // namespace ciel
