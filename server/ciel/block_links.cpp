#include "ciel/block_links.hpp"

#include "ciel/parallel.hpp"

#include <algorithm>

namespace ciel {

namespace {

constexpr std::size_t blocks_per_task = 8;

// `body(block)` for all blocks in parallel.
template <class F>
void for_blocks(std::size_t count, F&& body) {
    parallel_for(count, blocks_per_task, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) body(static_cast<Index>(b));
    });
}

class Linker {
public:
    Linker(const FaceMeshView& mesh, std::vector<BuiltBlock>& built, Topology::Blocks& out)
        : mesh_(mesh), built_(built), out_(out) {}

    void run() {
        number_half_edges();
        ring_vertices();
        own_edges();
        for_blocks(built_.size(), [&](Index b) { renumber_edges(b); });
        join_twins();
        for (BuiltBlock& b : built_) out_.block.push_back(std::move(b.block));
    }

private:
    struct SharedEdge {
        Index high, block, edge;
    };

    void number_half_edges();
    void ring_vertices();
    void own_edges();
    [[nodiscard]] std::vector<std::vector<std::pair<Index, SharedEdge>>> shared_edges() const;
    void renumber_edges(Index b);
    void join_twins();

    const FaceMeshView& mesh_;
    std::vector<BuiltBlock>& built_;
    Topology::Blocks& out_;
    struct Owner {
        Index edge, block, owner_edge; // a local edge that the local edge of another block owns
    };
    std::vector<std::vector<Owner>> ghosts_;   // per block
    std::vector<std::vector<Index>> new_edge_; // per block: local edge -> its place among the owned, none for ghosts
};

void Linker::number_half_edges() {
    std::uint64_t half_edges = 0, vertices = 0;
    for (BuiltBlock& b : built_) {
        b.block.half_edge_begin = static_cast<Index>(half_edges);
        b.block.vertex_begin = static_cast<Index>(vertices);
        half_edges += b.block.with([](const auto& arrays) { return arrays.mate_face.size(); });
        vertices += b.block.vertex.size();
        if (half_edges >= none || vertices >= none)
            fail("a mesh holds fewer than 4,294,967,295 half-edges: split the dataset");
    }
    out_.counts.half_edges = half_edges;
    out_.block_at.resize((half_edges >> 12) + 1);
    Index b = 0;
    for (std::size_t i = 0; i < out_.block_at.size(); ++i) {
        while (b + 1 < built_.size() && built_[b + 1].block.half_edge_begin <= i << 12) ++b;
        out_.block_at[i] = b;
    }
}

void Linker::ring_vertices() {
    out_.first_slot.assign(mesh_.vertex_count(), none);
    std::vector<Index> last(mesh_.vertex_count(), none), next; // slots
    for (const BuiltBlock& b : built_) {
        Index slot = b.block.vertex_begin;
        next.resize(slot + b.block.vertex.size(), none);
        for (const Index v : b.block.vertex) {
            if (last[v] == none) {
                out_.first_slot[v] = slot;
            } else {
                next[last[v]] = slot;
                next[slot] = out_.first_slot[v]; // until a later block has it too
            }
            last[v] = slot++;
        }
    }
    for_blocks(built_.size(), [&](Index b) {
        Block& block = built_[b].block;
        std::visit(
            [&](auto& arrays) {
                for (Index local = 0; local < block.vertex.size(); ++local) {
                    if (next[block.vertex_begin + local] == none) continue;
                    arrays.border_vertex.push_back(static_cast<std::decay_t<decltype(arrays.end_of_list)>>(local));
                    block.border_next.push_back(next[block.vertex_begin + local]);
                }
                arrays.border_vertex.shrink_to_fit();
            },
            block.arrays);
        block.border_next.shrink_to_fit();
    });
    out_.counts.vertices = mesh_.vertex_count();
}

// Edges that may be in several blocks: both ends are. By block; each with its lower mesh vertex.
std::vector<std::vector<std::pair<Index, Linker::SharedEdge>>> Linker::shared_edges() const {
    std::vector<std::vector<std::pair<Index, SharedEdge>>> shared(built_.size());
    for_blocks(built_.size(), [&](Index b) {
        const Block& block = built_[b].block;
        block.with([&](const auto& arrays) {
            std::vector<std::uint8_t> border(block.vertex.size(), 0);
            for (const auto v : arrays.border_vertex) border[v] = 1;
            for (Index e = 0; e < arrays.edge_low.size(); ++e)
                if (border[arrays.edge_low[e]] && border[arrays.edge_high[e]])
                    shared[b].push_back({block.vertex[arrays.edge_low[e]], {block.vertex[arrays.edge_high[e]], b, e}});
        });
    });
    return shared;
}

// Equal edges meet in the list of their lower vertex; the first block owns them. Lists are filled block by block, so
// they are sorted by block.
void Linker::own_edges() {
    const auto shared = shared_edges();
    std::vector<std::uint64_t> begin(std::size_t{mesh_.vertex_count()} + 1, 0);
    for (const auto& edges : shared)
        for (const auto& [low, edge] : edges) ++begin[low + 1];
    for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
    std::vector<SharedEdge> list(begin.back());
    std::vector<std::uint64_t> cursor(begin.begin(), begin.end() - 1);
    for (const auto& edges : shared)
        for (const auto& [low, edge] : edges) list[cursor[low]++] = edge;

    ghosts_.resize(built_.size());
    for (std::size_t v = 0; v + 1 < begin.size(); ++v)
        for (std::uint64_t i = begin[v] + 1; i < begin[v + 1]; ++i)
            for (std::uint64_t j = begin[v]; j < i; ++j)
                if (list[j].high == list[i].high) {
                    ghosts_[list[i].block].push_back({list[i].edge, list[j].block, list[j].edge});
                    break;
                }

    new_edge_.resize(built_.size());
    std::uint64_t edges = 0;
    for (Index b = 0; b < built_.size(); ++b) {
        Block& block = built_[b].block;
        new_edge_[b].assign(block.with([](const auto& arrays) { return arrays.edge_low.size(); }), 0);
        for (const Owner& ghost : ghosts_[b]) new_edge_[b][ghost.edge] = none;
        Index owned = 0;
        for (Index& e : new_edge_[b])
            if (e != none) e = owned++;
        block.edge_begin = static_cast<Index>(edges);
        out_.edge_begin.push_back(block.edge_begin);
        edges += owned;
    }
    out_.edge_begin.push_back(static_cast<Index>(edges));
    out_.counts.edges = edges; // fewer than half-edges, so they fit
}

void Linker::renumber_edges(Index b) {
    Block& block = built_[b].block;
    std::vector<std::pair<Index, Index>> ghosts; // (mesh-wide id, old local edge)
    for (const Owner& ghost : ghosts_[b])
        ghosts.emplace_back(built_[ghost.block].block.edge_begin + new_edge_[ghost.block][ghost.owner_edge],
                            ghost.edge);
    std::ranges::sort(ghosts);
    std::vector<Index> renumbered = new_edge_[b];
    for (Index& e : renumbered)
        if (e != none) e += static_cast<Index>(ghosts.size());
    for (const auto& [id, edge] : ghosts) {
        renumbered[edge] = static_cast<Index>(block.ghost_edge.size());
        block.ghost_edge.push_back(id);
    }
    block.ghost_edge.shrink_to_fit();
    std::visit(
        [&](auto& arrays) {
            const auto low = arrays.edge_low, high = arrays.edge_high;
            arrays.edge_low.shrink_to_fit();
            arrays.edge_high.shrink_to_fit();
            for (std::size_t e = 0; e < low.size(); ++e) {
                arrays.edge_low[renumbered[e]] = low[e];
                arrays.edge_high[renumbered[e]] = high[e];
            }
            for (auto& e : arrays.edge) e = static_cast<std::decay_t<decltype(e)>>(renumbered[e]);
        },
        block.arrays);
}

void Linker::join_twins() {
    std::vector<std::array<HalfEdge, 2>> first(mesh_.face_count(), {none, none}); // by side, at the first corner
    const auto for_tail = [&](Index b, auto&& visit) {
        BuiltBlock& built = built_[b];
        for (Index i = 0; i < built.tail_face.size(); ++i) {
            const Index corner = built.block.face_begin[built.block.inner_faces + i];
            visit(built.tail_face[i], built.block.half_edge(corner, 0), corner >= built.block.far_corner ? 1U : 0U);
        }
    };
    for_blocks(built_.size(), [&](Index b) {
        for_tail(b,
                 [&](Index face, Index h, unsigned side) { first[face][side] = built_[b].block.half_edge_begin + h; });
    });
    for_blocks(built_.size(), [&](Index b) {
        for_tail(b,
                 [&](Index face, Index, unsigned side) { built_[b].block.tail_twin.push_back(first[face][1 - side]); });
        built_[b].block.tail_twin.shrink_to_fit();
    });
}

} // namespace

void link_blocks(const FaceMeshView& mesh, std::vector<BuiltBlock>& built, Topology::Blocks& out) {
    Linker(mesh, built, out).run();
}

} // namespace ciel
