// Number of blocks per task. Not in the paper.
#pragma once

#include "ciel/parallel.hpp"

#include <algorithm>

namespace ciel::detail {

// Returns at most `most`; less for few blocks, so that each thread gets about 8 tasks and all finish together.
[[nodiscard]] inline std::size_t fair_grain(std::size_t count, std::size_t most) {
    constexpr std::size_t tasks_per_thread = 8;
    return std::clamp<std::size_t>(count / (tasks_per_thread * thread_count()), 1, most);
}

} // namespace ciel::detail
