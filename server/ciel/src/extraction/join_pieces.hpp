// Joins the pieces of one value of a sweep. Not in the paper, which draws polygon by polygon (algorithm 3).
#pragma once

#include "ciel/types.hpp"

#include <algorithm>
#include <functional>
#include <span>

namespace ciel::detail {

template <class Piece, class Array>
void join_arrays(std::span<const Piece* const> pieces, Array array, Piece& out) {
    auto& to = std::invoke(array, out);
    std::size_t size = 0;
    for (const Piece* piece : pieces) size += std::invoke(array, *piece).size();
    to.clear();
    to.reserve(size);
    for (const Piece* piece : pieces) {
        const auto& from = std::invoke(array, *piece);
        to.insert(to.end(), from.begin(), from.end());
    }
}

// Adds to the indices of each piece the number of points in the pieces before it. points(piece): its points.
template <class Piece, class Points>
void join_triangles(std::span<const Piece* const> pieces, Points points, Piece& out) {
    std::size_t corners = 0;
    for (const Piece* piece : pieces) corners += piece->triangles.size();
    out.triangles.resize(corners);
    Index first = 0;
    Index* to = out.triangles.data();
    for (const Piece* piece : pieces) {
        to = std::ranges::transform(piece->triangles, to, [first](Index p) { return first + p; }).out;
        first += static_cast<Index>(std::invoke(points, *piece).size());
    }
}

} // namespace ciel::detail
