// Gradients of a scalar field at the vertices (paper, section 3): the cells' own, averaged by volume. Only where
// somebody asks.
//
// A vertex's sum is made in the order of (kind of cell, cell), never block by block, so that it has the same bits
// whatever the size of the blocks.
#pragma once

#include "blocks/active_block.hpp"
#include "ciel/field.hpp"
#include "ciel/threads.hpp"
#include "fields/cell_gradient.hpp"

namespace ciel {

// Thread-safe. All calls must pass the same topology, field and positions, until forget.
class GradientCache {
public:
    // Makes the gradients at both ends of the edges that the cut blocks own. `cut` is by block. Where there is no
    // memory it throws, and the next call makes what is missing.
    void make_at(const FaceMeshView& mesh, const Field::Data& field, std::span<const Index> blocks,
                 std::span<const ActiveBlock> cut);
    // By local vertex; good where asked for. Valid while the cache lives and nobody calls forget.
    [[nodiscard]] const Vec3f* of_block(Index block) const { return vertex_[block].get(); }
    // The positions have changed. Not while anybody uses the gradients.
    void forget();
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    mutable Mutex mutex_;
    std::vector<std::uint8_t> state_;              // by slot (Block::vertex_begin): see gradient.cpp
    std::vector<std::uint8_t> busy_;               // by block, of one call
    std::vector<std::unique_ptr<Vec3f[]>> vertex_; // by block
    bool settled_ = true;                          // the last call came to its end: nobody waits for a gradient
};

// At all vertices, by mesh vertex.
[[nodiscard]] std::vector<Vec3f> gradients_everywhere(const FaceMeshView& mesh, const Field::Data& field);

} // namespace ciel
