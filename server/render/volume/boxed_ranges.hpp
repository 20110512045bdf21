// Triangle lists split into ranges of a few hundred triangles, each with a bounding box, to skip invisible ranges.
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

struct BoxedRange {
    IndexRange range;
    Vec3f low, high; // box of its positions
};

// Splits `triangles`, which the index buffer holds at `range`, into consecutive ranges. `at` returns the position of a
// vertex.
[[nodiscard]] std::vector<BoxedRange> boxed_ranges_of(const IndexRange& range, std::span<const Index> triangles,
                                                      const std::function<const Vec3f&(Index)>& at);

} // namespace ciel::render
