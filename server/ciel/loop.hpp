// A face's loop without the repeats that collapsed cells bring: no half-edge joins a vertex to itself. What the paper's
// appendix A has no rule for.
#pragma once

#include "ciel/types.hpp"

#include <span>
#include <vector>

namespace ciel {

// Appends `loop` to `out`, leaving out each vertex that equals its successor around the loop. A loop that collapsed to
// a point appends nothing, one that collapsed to a line appends both of its ends. Returns how many were appended.
inline std::size_t append_without_repeats(std::span<const Index> loop, std::vector<Index>& out) {
    const std::size_t before = out.size();
    for (std::size_t i = 0; i < loop.size(); ++i)
        if (loop[i] != loop[i + 1 == loop.size() ? 0 : i + 1]) out.push_back(loop[i]);
    return out.size() - before;
}

} // namespace ciel
