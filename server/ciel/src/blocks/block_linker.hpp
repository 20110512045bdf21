// Links the built blocks of a mesh (paper, appendix A): mesh-wide ids, rings of the blocks of each shared vertex,
// owners of shared edges, and twins of tails.
#pragma once

#include "blocks/block_builder.hpp"
#include "blocks/block_records.hpp"
#include "blocks/open_edges.hpp"

#include <functional>
#include <memory>

namespace ciel::detail {

// Takes the blocks of a mesh in ascending order. Keeps the data that a block shares with later blocks, until the last
// of these blocks is added. The record `cells` refers to earlier blocks only, so it is complete at once. The record
// `around` is complete when no later block shares a vertex with the block or with the next blocks in its rings. The
// record `mates` is complete when no later block shares a face with the block. Not thread-safe.
class BlockLinker {
public:
    struct CompleteRecord {
        Index block;
        RecordKind kind;
        std::function<RecordBytes()> make; // call it once, on any thread
    };

    // `last_cell`: by vertex, the last cell that has a face with the vertex. Must outlive the object.
    explicit BlockLinker(std::span<const Index> last_cell);
    ~BlockLinker();
    BlockLinker(const BlockLinker&) = delete;
    BlockLinker& operator=(const BlockLinker&) = delete;

    // Returns the records that are complete now, also those of earlier blocks. Throws Error when ids do not fit 32
    // bits, or when vertices are not in the order of first use.
    [[nodiscard]] std::vector<CompleteRecord> add(BuiltBlock&& built);
    // Call it after the last block. Throws Error if a record is incomplete, because the mesh contradicts itself.
    void finish();

    [[nodiscard]] BlockNumbers& numbers() { return numbers_; } // complete after finish()
    [[nodiscard]] std::uint64_t half_edge_count() const { return half_edges_; }
    [[nodiscard]] std::uint64_t edge_count() const { return edges_; }

private:
    struct Pending; // the data that a block shares with later blocks

    void own_vertices(BuiltBlock& built);
    void share_vertices(const BuiltBlock& built);
    void close_vertex(Index vertex, Index owner);
    void complete_border(Index b);
    void complete_around(Index b);
    // Returns the new local id of each local edge.
    [[nodiscard]] std::vector<Index> own_edges(BuiltBlock& built);
    void join_twins(const BuiltBlock& built);
    void complete_mates(Index b);
    void release(Index b);
    [[nodiscard]] Pending& pending(Index b);
    [[nodiscard]] bool is_open(Index vertex) const { return last_cell_[vertex] >= cell_end_; }

    std::span<const Index> last_cell_;
    BlockNumbers numbers_;
    std::uint64_t half_edges_ = 0, edges_ = 0, slots_ = 0;
    Index vertices_ = 0, cell_end_ = 0;
    std::vector<std::unique_ptr<Pending>> pending_; // by block; null after its records are complete
    std::vector<std::vector<Index>> border_;        // by block: its border vertices; empty until all are known
    std::vector<std::vector<Index>> waiting_;       // by block: blocks whose record `around` waits for its border_
    OpenEdges open_edges_;
    std::vector<CompleteRecord> complete_;
};

} // namespace ciel::detail
