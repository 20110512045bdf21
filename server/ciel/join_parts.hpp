// How a sink of a sweep joins the parts of one value: arrays end to end, and triangles counted on. Not in the paper,
// which draws polygon by polygon (algorithm 3).
#pragma once

#include "ciel/types.hpp"

#include <algorithm>
#include <functional>
#include <span>

namespace ciel {

// `array(part)` is the array to join; the buffer of `out` is used again.
template <class Part, class Array>
void join_arrays(std::span<const Part* const> parts, Array array, Part& out) {
    auto& to = std::invoke(array, out);
    std::size_t size = 0;
    for (const Part* part : parts) size += std::invoke(array, *part).size();
    to.clear();
    to.reserve(size);
    for (const Part* part : parts) {
        const auto& from = std::invoke(array, *part);
        to.insert(to.end(), from.begin(), from.end());
    }
}

// The triangles of parts whose points are `points(part)`, as indices into the joined points.
template <class Part, class Points>
void join_triangles(std::span<const Part* const> parts, Points points, Part& out) {
    std::size_t corners = 0;
    for (const Part* part : parts) corners += part->triangles.size();
    out.triangles.resize(corners);
    Index first = 0;
    Index* to = out.triangles.data();
    for (const Part* part : parts) {
        to = std::ranges::transform(part->triangles, to, [first](Index p) { return first + p; }).out;
        first += static_cast<Index>(std::invoke(points, *part).size());
    }
}

} // namespace ciel
