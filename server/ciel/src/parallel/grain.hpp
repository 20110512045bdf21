// Number of blocks per task. Not in the paper.
#pragma once

#include "ciel/parallel.hpp"

#include <algorithm>

namespace ciel::detail {

// Returns the number of blocks per task: at most `most`, and fewer if there are few blocks. Each thread then gets about
// 8 tasks, so that all threads finish together.
[[nodiscard]] inline std::size_t fair_grain(std::size_t count, std::size_t most) {
    constexpr std::size_t tasks_per_thread = 8;
    return std::clamp<std::size_t>(count / (tasks_per_thread * thread_count()), 1, most);
}

} // namespace ciel::detail
