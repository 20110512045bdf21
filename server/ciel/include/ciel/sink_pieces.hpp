// Checks the arrays of a sink and joins its pieces (sweep_sinks.hpp), for the sinks of the kernel and of callers. Any
// thread may call the functions. Not in the paper, which draws polygon by polygon (algorithm 3).
#pragma once

#include "ciel/types.hpp"

#include <algorithm>
#include <functional>
#include <span>
#include <string>

namespace ciel {

// Throws Error unless `found` equals `wanted`. `what`: names the entries of the array in the message.
inline void require_size(std::size_t found, std::uint64_t wanted, const char* what) {
    if (found != wanted)
        fail("an array of a sink must have " + std::to_string(wanted) + " " + what + "; it has " +
             std::to_string(found));
}

// Sets an array of `out` to the concatenated arrays of the pieces. array(piece) returns a reference to the array.
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

// Sets out.triangles to the triangles of the pieces. Adds to the indices of each piece the number of points in the
// pieces before it. points(piece) returns the points of the piece.
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
