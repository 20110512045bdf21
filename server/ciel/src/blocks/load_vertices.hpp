// Makes the positions of a block's vertices ready to be read. Not in the paper.
#pragma once

#include "blocks/block.hpp"
#include "ciel/value_source.hpp"

namespace ciel::detail {

// Call it before the positions are read. `loader`: FaceMeshView::loader; null if all positions are ready.
inline void load_vertices(const VertexLoader* loader, Index b, const Block& block) {
    if (loader == nullptr || loader->has_block(b)) return;
    const auto own = block.vertex_count - static_cast<Index>(block.ghost_vertex.size());
    if (own > 0) loader->load(block.own_vertex_begin, block.own_vertex_begin + own);
    block.ghost_vertex.for_each([&](Index vertex) { loader->load(vertex, vertex + 1); });
    loader->set_has_block(b);
}

} // namespace ciel::detail
