// The caller's values in the order of the stored mesh. Not in the paper.
#pragma once

#include "ciel/mesh.hpp"

#include <vector>

namespace ciel {

enum class PerItem { point, cell };

// Returns the values in stored order, as floats. values: one number per point or cell of the caller's mesh. Throws
// Error on another number of rows or columns.
[[nodiscard]] std::vector<float> stored_values(const Mesh& mesh, const ArrayView& values, PerItem item);

} // namespace ciel
