// How a sink of a sweep joins the pieces of one value: concatenates arrays and offsets triangle indices. Not in the
// paper, which draws polygon by polygon (algorithm 3).
#pragma once

#include "ciel/types.hpp"

#include <algorithm>
#include <functional>
#include <span>

namespace ciel {

// Concatenates array(piece) of all pieces into array(out), whose buffer is reused.
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

// Concatenates the triangles of all pieces and offsets their indices into the joined points. points(piece): the points
// of a piece.
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

} // namespace ciel
