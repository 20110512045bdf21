#include "blocks/block_links.hpp"

#include "blocks/blocks.hpp"
#include "ciel/parallel.hpp"

#include <algorithm>
#include <tuple>

namespace ciel::detail {

namespace {

constexpr std::size_t blocks_per_task = 8;

template <class F>
void for_blocks(std::size_t count, F&& body) {
    parallel_for(count, blocks_per_task, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) body(static_cast<Index>(b));
    });
}

void sort_once(std::vector<Index>& blocks) {
    std::ranges::sort(blocks);
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    blocks.shrink_to_fit();
}

Index place_in(std::span<const Index> sorted, Index block) {
    return static_cast<Index>(std::ranges::lower_bound(sorted, block) - sorted.begin());
}

class RecordsInMemory final : public RecordSource {
public:
    explicit RecordsInMemory(std::size_t blocks) : records_(blocks) {}

    void set(Index block, std::array<RecordBytes, 3> records) { records_[block] = std::move(records); }
    std::span<const std::byte> record(Index block, RecordKind kind) override {
        const auto& [cells, around, mates] = records_[block];
        switch (kind) {
        case RecordKind::cells:
            return std::as_bytes(std::span(cells));
        case RecordKind::around:
            return std::as_bytes(std::span(around));
        case RecordKind::mates:
            break;
        }
        return std::as_bytes(std::span(mates));
    }
    bool is_trusted() const override { return true; }
    std::size_t memory_bytes() const override {
        std::size_t sum = records_.capacity() * sizeof(records_[0]);
        for (const auto& of_block : records_)
            for (const RecordBytes& one : of_block) sum += one.capacity() * sizeof(one[0]);
        return sum;
    }

private:
    std::vector<std::array<RecordBytes, 3>> records_;
};

class Linker {
public:
    Linker(const FaceMeshView& mesh, std::vector<BuiltBlock>& built, Topology::Blocks& out)
        : mesh_(mesh), built_(built), out_(out) {}

    void run() {
        count_half_edges();
        own_vertices();
        ring_vertices();
        own_edges();
        number_edges();
        for_blocks(built_.size(), [&](Index b) { renumber_edges(b); });
        join_twins();
        write_records();
    }

private:
    struct SharedEdge {
        Index high, block, edge;
    };
    struct SharedLists {
        std::vector<std::uint64_t> begin; // by mesh vertex: first index in `edge`; then the size of `edge`
        std::vector<SharedEdge> edge;
    };

    void count_half_edges();
    void own_vertices();
    void ring_vertices();
    void link_border(Index b, std::span<const Index> next);
    [[nodiscard]] SharedLists list_by_lower_vertex() const;
    void own_edges();
    void give_to_first(std::span<SharedEdge> edges);
    void number_edges();
    [[nodiscard]] std::vector<std::vector<std::pair<Index, SharedEdge>>> shared_edges() const;
    void renumber_edges(Index b);
    void join_twins();
    [[nodiscard]] HalfEdge turn_in_mesh(HalfEdge h, Index steps) const;
    void write_records();
    static void name_twins(std::span<const HalfEdge> twins, BlockMatesOf<Owned>& mates);

    const FaceMeshView& mesh_;
    std::vector<BuiltBlock>& built_;
    Topology::Blocks& out_;
    struct Owner {
        Index edge, block, owner_edge; // local id of a ghost edge; its owner; its local id in the owner
    };
    std::vector<std::vector<Owner>> ghosts_;   // by block: its ghost edges
    std::vector<std::vector<Index>> new_edge_; // by block, local edge: index among the owned edges; none for ghosts
};

void Linker::count_half_edges() {
    std::uint64_t half_edges = 0, vertices = 0;
    for (BuiltBlock& b : built_) {
        b.block.vertex_begin = static_cast<Index>(vertices);
        half_edges += b.block.half_edge_count;
        vertices += b.block.vertex_count;
        if (vertices >= none)
            fail("the blocks of the mesh have more than 4,294,967,294 vertices together; split the dataset");
    }
    out_.counts.half_edges = half_edges;
    out_.counts.vertices = mesh_.vertex_count();
}

// Vertices are numbered by first use, so the vertices that a block owns have consecutive ids.
void Linker::own_vertices() {
    Index owned = 0;
    for (BuiltBlock& b : built_) {
        BlockOf<Owned>& block = b.block;
        block.own_vertex_begin = owned;
        const auto first = std::ranges::lower_bound(b.vertices, owned);
        block.ghost_vertex.assign(b.vertices.begin(), first);
        for (auto v = first; v != b.vertices.end(); ++v)
            if (*v != owned++)
                fail("the mesh is damaged: its vertices are not in the order of their first use; import it again");
    }
}

void Linker::ring_vertices() {
    // A slot is Block::vertex_begin + local vertex. By mesh vertex: `first` and `last` are its first and last slot so
    // far. By slot: `next` is the next slot in the ring of the vertex.
    std::vector<Index> first(mesh_.vertex_count(), none), last(mesh_.vertex_count(), none), next;
    for (const BuiltBlock& b : built_) {
        Index slot = b.block.vertex_begin;
        next.resize(slot + b.vertices.size(), none);
        for (const Index v : b.vertices) {
            if (last[v] == none) {
                first[v] = slot;
            } else {
                next[last[v]] = slot;
                next[slot] = first[v]; // closes the ring; replaced if a later block has v, too
            }
            last[v] = slot++;
        }
    }
    for_blocks(built_.size(), [&](Index b) {
        std::visit(
            [&](auto& arrays) {
                for (Index local = 0; local < built_[b].block.vertex_count; ++local)
                    if (next[built_[b].block.vertex_begin + local] != none)
                        arrays.border_vertex.push_back(
                            static_cast<std::decay_t<decltype(arrays.border_vertex[0])>>(local));
                arrays.border_vertex.shrink_to_fit();
            },
            built_[b].around.arrays);
    });
    for_blocks(built_.size(), [&](Index b) { link_border(b, next); });
}

void Linker::link_border(Index b, std::span<const Index> next) {
    const BlockOf<Owned>& block = built_[b].block;
    BlockAroundOf<Owned>& around = built_[b].around;
    const auto block_with = [&](Index slot) {
        const auto after =
            std::ranges::upper_bound(built_, slot, {}, [](const BuiltBlock& one) { return one.block.vertex_begin; });
        return static_cast<Index>(after - built_.begin() - 1);
    };
    std::visit(
        [&](auto& arrays) {
            using Local = std::decay_t<decltype(arrays.border_vertex[0])>;
            std::vector<Index> there;
            for (const Index local : arrays.border_vertex)
                there.push_back(block_with(next[block.vertex_begin + local]));
            around.neighbour = there;
            sort_once(around.neighbour);
            arrays.border_block.reserve(there.size());
            arrays.border_place.reserve(there.size());
            for (std::size_t i = 0; i < there.size(); ++i) {
                const BuiltBlock& other = built_[there[i]];
                const Index local = next[block.vertex_begin + arrays.border_vertex[i]] - other.block.vertex_begin;
                arrays.border_block.push_back(static_cast<Local>(place_in(around.neighbour, there[i])));
                arrays.border_place.push_back(static_cast<Local>(other.around.border_place_of(local)));
            }
        },
        around.arrays);
}

// Returns the edges whose two ends are border vertices, each with its lower mesh vertex.
std::vector<std::vector<std::pair<Index, Linker::SharedEdge>>> Linker::shared_edges() const {
    std::vector<std::vector<std::pair<Index, SharedEdge>>> shared(built_.size());
    for_blocks(built_.size(), [&](Index b) {
        const BlockOf<Owned>& block = built_[b].block;
        built_[b].around.with([&](const auto& arrays) {
            std::vector<std::uint8_t> border(block.vertex_count, 0);
            for (const auto v : arrays.border_vertex) border[v] = 1;
            for (Index e = 0; e < block.edge_count; ++e) {
                const auto [low, high] = built_[b].edge_ends[e];
                if (border[low] && border[high]) shared[b].push_back({block.vertex(low), {block.vertex(high), b, e}});
            }
        });
    });
    return shared;
}

// `edges` have the same lower vertex and are ordered by block. Sorting a long list avoids quadratic time.
void Linker::give_to_first(std::span<SharedEdge> edges) {
    constexpr std::size_t short_list = 64;
    const auto give = [this](const SharedEdge& ghost, const SharedEdge& owner) {
        ghosts_[ghost.block].push_back({ghost.edge, owner.block, owner.edge});
    };
    if (edges.size() > short_list) {
        std::ranges::sort(edges, {}, [](const SharedEdge& e) { return std::tuple(e.high, e.block, e.edge); });
        for (std::size_t i = 1, owner = 0; i < edges.size(); ++i)
            if (edges[i].high == edges[owner].high)
                give(edges[i], edges[owner]);
            else
                owner = i;
        return;
    }
    for (std::size_t i = 1; i < edges.size(); ++i) {
        const auto owner = std::ranges::find(edges.first(i), edges[i].high, &SharedEdge::high);
        if (owner != edges.begin() + static_cast<std::ptrdiff_t>(i)) give(edges[i], *owner);
    }
}

Linker::SharedLists Linker::list_by_lower_vertex() const {
    const auto shared = shared_edges();
    SharedLists lists;
    lists.begin.assign(std::size_t{mesh_.vertex_count()} + 1, 0);
    for (const auto& edges : shared)
        for (const auto& [low, edge] : edges) ++lists.begin[low + 1];
    for (std::size_t v = 1; v < lists.begin.size(); ++v) lists.begin[v] += lists.begin[v - 1];
    lists.edge.resize(lists.begin.back());
    std::vector<std::uint64_t> cursor(lists.begin.begin(), lists.begin.end() - 1);
    for (const auto& edges : shared)
        for (const auto& [low, edge] : edges) lists.edge[cursor[low]++] = edge;
    return lists;
}

// All copies of an edge are in the list of its lower vertex.
void Linker::own_edges() {
    SharedLists lists = list_by_lower_vertex();
    ghosts_.resize(built_.size());
    for (std::size_t v = 0; v + 1 < lists.begin.size(); ++v)
        give_to_first(std::span(lists.edge).subspan(lists.begin[v], lists.begin[v + 1] - lists.begin[v]));
}

// The edges that a block owns have consecutive ids; a ghost edge has the id that its owner assigns.
void Linker::number_edges() {
    new_edge_.resize(built_.size());
    std::uint64_t edges = 0;
    for (Index b = 0; b < built_.size(); ++b) {
        BlockOf<Owned>& block = built_[b].block;
        new_edge_[b].assign(block.edge_count, 0);
        for (const Owner& ghost : ghosts_[b]) new_edge_[b][ghost.edge] = none;
        Index owned = 0;
        for (Index& e : new_edge_[b])
            if (e != none) e = owned++;
        block.edge_begin = static_cast<Index>(edges);
        out_.numbers.edge.push_back(block.edge_begin);
        edges += owned;
    }
    if (!built_.empty()) out_.numbers.edge.push_back(static_cast<Index>(edges));
    if (edges >= none) fail("the mesh has more than 4,294,967,294 edges; split the dataset");
    out_.counts.edges = edges;
}

void Linker::renumber_edges(Index b) {
    BlockOf<Owned>& block = built_[b].block;
    std::vector<std::pair<Index, Index>> ghosts; // (mesh-wide id, old local id) of each ghost edge
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
    const auto renumber = [&](auto& edges) {
        for (auto& e : edges) e = static_cast<std::decay_t<decltype(e)>>(renumbered[e]);
    };
    for (StandardSectionOf<Owned>& section : block.standard) renumber(section.edge);
    std::visit([&](auto& polyhedra) { renumber(polyhedra.edge); }, block.polyhedra);
}

void Linker::join_twins() {
    std::vector<std::array<HalfEdge, 2>> anchor(mesh_.face_count(), {no_half_edge, no_half_edge}); // [face][side]
    for_blocks(built_.size(), [&](Index b) {
        for (const BuiltBlock::Tail& tail : built_[b].tails)
            anchor[tail.face][tail.side] = half_edge_in(b, tail.anchor);
    });
    for_blocks(built_.size(), [&](Index b) {
        std::vector<HalfEdge> twins;
        twins.reserve(built_[b].tails.size());
        for (const BuiltBlock::Tail& tail : built_[b].tails) {
            const HalfEdge other = tail.mate != none ? half_edge_in(b, tail.mate) : anchor[tail.face][1 - tail.side];
            twins.push_back(other == no_half_edge ? other : turn_in_mesh(other, tail.steps));
        }
        name_twins(twins, built_[b].mates);
    });
}

HalfEdge Linker::turn_in_mesh(HalfEdge h, Index steps) const {
    return half_edge_in(block_of(h), turn(built_[block_of(h)].block, local_of(h), steps));
}

void Linker::name_twins(std::span<const HalfEdge> twins, BlockMatesOf<Owned>& mates) {
    for (const HalfEdge twin : twins)
        if (twin != no_half_edge) mates.neighbour.push_back(block_of(twin));
    sort_once(mates.neighbour);
    mates.twin_half_edge.reserve(twins.size());
    std::visit(
        [&](auto& arrays) {
            arrays.twin_block.reserve(twins.size());
            for (const HalfEdge twin : twins) {
                const bool is_none = twin == no_half_edge;
                const Index place = is_none ? arrays.no_block : place_in(mates.neighbour, block_of(twin));
                arrays.twin_block.push_back(static_cast<std::decay_t<decltype(arrays.no_block)>>(place));
                mates.twin_half_edge.push_back(is_none ? 0 : local_of(twin));
            }
        },
        mates.arrays);
}

void Linker::write_records() {
    const std::size_t count = built_.size();
    for (const BuiltBlock& b : built_) {
        out_.numbers.cell.push_back(b.block.cell_begin);
        out_.numbers.vertex.push_back(b.block.own_vertex_begin);
        out_.numbers.slot.push_back(b.block.vertex_begin);
        out_.numbers.half_edges.push_back(b.block.half_edge_count);
        out_.numbers.border_vertices.push_back(
            b.around.with([](const auto& all) { return static_cast<Index>(all.border_vertex.size()); }));
    }
    if (count > 0) {
        const BlockOf<Owned>& last = built_.back().block;
        out_.numbers.cell.push_back(last.cell_begin + last.cell_count);
        out_.numbers.vertex.push_back(last.own_vertex_begin + last.vertex_count -
                                      static_cast<Index>(last.ghost_vertex.size()));
        out_.numbers.slot.push_back(last.vertex_begin + last.vertex_count);
    }
    auto records = std::make_unique<RecordsInMemory>(count);
    for_blocks(count, [&](Index b) {
        const BuiltBlock built = std::move(built_[b]);
        records->set(b, {record_of(built.block, b, out_.numbers), record_of(built.block, built.around, b),
                         record_of(built.block, built.mates, b)});
    });
    out_.source = std::move(records);
    out_.begin();
}

} // namespace

void link_blocks(const FaceMeshView& mesh, std::vector<BuiltBlock>& built, Topology::Blocks& out) {
    Linker(mesh, built, out).run();
}

} // namespace ciel::detail
