// Number of blocks per task. Not in the paper.
#pragma once

#include "ciel/parallel.hpp"

#include <algorithm>

namespace ciel {

// Returns the number of blocks for each task. It is at most `most`, and smaller if there are few blocks, so that each
// thread gets about 8 tasks. Then all threads finish at about the same time.
[[nodiscard]] inline std::size_t fair_grain(std::size_t count, std::size_t most) {
    constexpr std::size_t tasks_per_thread = 8;
    return std::clamp<std::size_t>(count / (tasks_per_thread * thread_count()), 1, most);
}

} // namespace ciel
