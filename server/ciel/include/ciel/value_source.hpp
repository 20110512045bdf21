// ValueSource and VertexLoader: read values and positions of vertices from a file, for a block of cells when the block
// is first used. Therefore the cost of a surface depends on the blocks that the surface crosses, not on the size of the
// mesh. Not in the paper, whose meshes are in memory.
#pragma once

#include "ciel/types.hpp"

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>

namespace ciel {

// The values of a Field: one for each vertex, in the topology's vertex order. Any thread may call the functions at any
// time. `read` throws Error when the values cannot be read; a later call may succeed.
class ValueSource {
public:
    ValueSource() = default;
    ValueSource(const ValueSource&) = delete;
    ValueSource& operator=(const ValueSource&) = delete;
    virtual ~ValueSource() = default;

    [[nodiscard]] virtual std::size_t size() const = 0; // number of vertices
    [[nodiscard]] virtual bool has_doubles() const = 0;
    // Sets out[i] to the value of vertex first + i. If has_doubles(), only the functions for doubles are called; else
    // only those for floats.
    virtual void read(Index first, std::span<float> out) const = 0;
    virtual void read(Index first, std::span<double> out) const = 0;
    // Sets out[i] to the value of vertices[i]. All these vertices exist.
    virtual void read(std::span<const Index> vertices, std::span<float> out) const = 0;
    virtual void read(std::span<const Index> vertices, std::span<double> out) const = 0;
};

// Makes positions in a file ready before they are read (FaceMeshView::loader). `blocks`: number of blocks of the
// topology.
class VertexLoader {
public:
    explicit VertexLoader(std::size_t blocks) : has_block_(std::make_unique<std::atomic<bool>[]>(blocks)) {}
    VertexLoader(const VertexLoader&) = delete;
    VertexLoader& operator=(const VertexLoader&) = delete;
    virtual ~VertexLoader() = default;

    // Makes the positions of the vertices `begin` to `end` - 1 ready to be read. All these vertices exist. Throws Error
    // when a position cannot be read. Any thread may call `load` at any time.
    virtual void load(Index begin, Index end) const = 0;
    // Return and set whether the positions of all vertices of a block are ready. The kernel sets this after it has
    // loaded the positions, and then skips `load` for the block. Any thread may call both functions.
    [[nodiscard]] bool has_block(Index block) const { return has_block_[block].load(std::memory_order_acquire); }
    void set_has_block(Index block) const { has_block_[block].store(true, std::memory_order_release); }

private:
    std::unique_ptr<std::atomic<bool>[]> has_block_;
};

} // namespace ciel
