// Triangle lists split into parts of a few hundred triangles, each with a bounding box, to skip invisible parts.
#pragma once

#include "ciel/slab.hpp"
#include "render/context/gl.hpp"

#include <functional>
#include <span>
#include <vector>

namespace ciel::render {

// Consecutive entries of an index buffer; `base` is added to each index.
struct IndexRange {
    std::size_t first = 0;
    GLsizei count = 0;
    GLint base = 0;
};

struct IndexPart {
    IndexRange range;
    Vec3f low, high; // box of the part's positions
};

// Splits `triangles`, which the index buffer holds at `range`, into consecutive parts. `at` returns the position of a
// vertex.
[[nodiscard]] std::vector<IndexPart> parts_of(const IndexRange& range, std::span<const Index> triangles,
                                              const std::function<const Vec3f&(Index)>& at);

} // namespace ciel::render
