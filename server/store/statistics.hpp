// Ranges of an array at one step.
#pragma once

#include "store/dataset.hpp"

namespace ciel::store {

[[nodiscard]] ArrayStep statistics(std::span<const float> values, int components);

} // namespace ciel::store
