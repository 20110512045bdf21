#include "mesh/repeated_cells.hpp"

#include "mesh/loop.hpp"

#include <algorithm>
#include <map>

namespace ciel::detail {

namespace {

using Loop = std::vector<Index>;

// Returns the lexicographically least rotation of the loop or of the reversed loop. Equal faces have the same result.
Loop canonical(const Loop& loop) {
    const std::size_t n = loop.size();
    const Index smallest = *std::ranges::min_element(loop);
    Loop least, other(n);
    for (std::size_t start = 0; start < n; ++start) {
        if (loop[start] != smallest) continue;
        for (const std::size_t step : {std::size_t{1}, n - 1}) {
            for (std::size_t i = 0, at = start; i < n; ++i, at = (at + step) % n) other[i] = loop[at];
            if (least.empty() || other < least) least = other;
        }
    }
    return least;
}

// Returns the sorted faces of a cell. Returns an empty list when all faces have collapsed, or when a face occurs twice.
std::vector<Loop> faces_of(const InputFaces& input, Index cell) {
    std::vector<Loop> faces;
    InputFaces::Corners corners;
    for (Index f = input.begin(cell); f < input.end(cell); ++f) {
        Loop loop;
        if (append_without_repeats(input.loop(cell, f, corners), loop) >= 3) faces.push_back(canonical(loop));
    }
    std::ranges::sort(faces);
    if (std::ranges::adjacent_find(faces) != faces.end()) faces.clear();
    return faces;
}

} // namespace

std::vector<Index> repeated_cells(const InputFaces& input, std::span<const Index> suspects) {
    std::map<std::vector<Loop>, Index> first;
    std::vector<Index> repeated;
    for (const Index cell : suspects) {
        std::vector<Loop> faces = faces_of(input, cell);
        if (!faces.empty() && !first.try_emplace(std::move(faces), cell).second) repeated.push_back(cell);
    }
    return repeated;
}

} // namespace ciel::detail
