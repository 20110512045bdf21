// Gradients of a scalar field at the vertices (paper, section 3): volume-weighted means of the cells' gradients. The
// gradients of the cells around a vertex are summed in the order of (cell type, cell), so that the bits of the sum do
// not depend on the block size.
#pragma once

#include "blocks/block_cuts.hpp"
#include "ciel/field.hpp"
#include "ciel/threads.hpp"
#include "fields/cell_gradient.hpp"
#include "fields/sparse_array.hpp"

namespace ciel::detail {

// Thread-safe. Until forget, all calls must pass the same topology, field and positions.
class GradientCache {
public:
    // Computes the gradients at both ends of the active edges that `blocks` own or adopt (AdoptedEdges). `cut`: has the
    // cuts of these blocks. May throw std::bad_alloc; the next call then computes the missing gradients.
    void make_at(const FaceMeshView& mesh, const Field::Data& field, std::span<const Index> blocks,
                 const BlockCuts& cut);
    // Returns the gradients of a block by local vertex. Only the entries that make_at computed are set. The array is
    // valid until forget or destruction.
    [[nodiscard]] const Vec3f* of_block(Index block) const { return vertex_[block].get(); }
    // Drops all gradients. Call it when the positions have changed. No thread may be using the gradients.
    void forget();
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    mutable Mutex mutex_;
    SparseArray<std::uint8_t> state_;              // by slot (Block::vertex_begin): State flags (gradient.cpp)
    std::vector<std::uint8_t> busy_;               // by block: 1 if it has cells to solve in the current call
    std::vector<std::unique_ptr<Vec3f[]>> vertex_; // by block: gradients by local vertex, or null
    bool settled_ = true; // whether the last make_at completed; if so, no vertex has the flag `wanted`
};

[[nodiscard]] std::vector<Vec3f> gradients_everywhere(const FaceMeshView& mesh, const Field::Data& field);

} // namespace ciel::detail
