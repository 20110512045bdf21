// How many blocks a task has. (Not in the paper.)
#pragma once

#include "ciel/parallel.hpp"

#include <algorithm>

namespace ciel {

// As many as are worth a task of their own, `most`; fewer where threads would not have several tasks each, so that they
// end together.
[[nodiscard]] inline std::size_t fair_grain(std::size_t count, std::size_t most) {
    constexpr std::size_t tasks_per_thread = 8;
    return std::clamp<std::size_t>(count / (tasks_per_thread * thread_count()), 1, most);
}

} // namespace ciel
