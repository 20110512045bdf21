// Splits triangle lists into ranges with bounding boxes, so that invisible ranges can be skipped.
#pragma once

#include "ciel/types.hpp"
#include "render/context/gl.hpp"

#include <functional>
#include <span>
#include <vector>

namespace server::render {

// Consecutive entries of an index buffer; `base` is added to each index.
struct IndexRange {
    std::size_t first = 0;
    GLsizei count = 0;
    GLint base = 0;
};

struct BoxedRange {
    IndexRange range;
    ciel::Vec3f low, high; // bounding box of the positions
};

// `range`: the part of the index buffer that contains `triangles`. `at`: returns the position of a vertex.
[[nodiscard]] std::vector<BoxedRange> boxed_ranges_of(const IndexRange& range, std::span<const ciel::Index> triangles,
                                                      const std::function<const ciel::Vec3f&(ciel::Index)>& at);

} // namespace server::render
