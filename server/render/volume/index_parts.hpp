// Triangles in parts of some hundred that lie together, to leave out those that cannot be seen: a part has a box.
#pragma once

#include "ciel/slab.hpp"
#include "render/context/gl.hpp"

#include <functional>
#include <span>
#include <vector>

namespace ciel::render {

// Consecutive entries of an index buffer, and what is added to them.
struct IndexRange {
    std::size_t first = 0;
    GLsizei count = 0;
    GLint base = 0;
};

struct IndexPart {
    IndexRange range;
    Vec3f low, high; // of positions
};

// Of the triangles that stand at `range`, in their order; `at`: the place of a vertex.
[[nodiscard]] std::vector<IndexPart> parts_of(const IndexRange& range, std::span<const Index> triangles,
                                              const std::function<const Vec3f&(Index)>& at);

} // namespace ciel::render
