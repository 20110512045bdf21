#include "blocks/block_linker.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace ciel::detail {

namespace {

void sort_once(std::vector<Index>& blocks) {
    std::ranges::sort(blocks);
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    blocks.shrink_to_fit();
}

Index place_in(std::span<const Index> sorted, Index block) {
    return static_cast<Index>(std::ranges::lower_bound(sorted, block) - sorted.begin());
}

// Returns the block that owns `id`. `begin`: first id that each block owns.
Index block_with(Index id, std::span<const Index> begin) {
    return static_cast<Index>(std::ranges::upper_bound(begin, id) - begin.begin() - 1);
}

[[noreturn]] void refuse(const char* what) { fail(std::string("the mesh is damaged: ") + what + "; import it again"); }

void renumber_edges(BlockOf<Owned>& block, std::span<const Index> renumbered) {
    const auto renumber = [&](auto& edges) {
        for (auto& e : edges) e = static_cast<std::decay_t<decltype(e)>>(renumbered[e]);
    };
    for (StandardSectionOf<Owned>& section : block.standard) renumber(section.edge);
    std::visit([&](auto& polyhedra) { renumber(polyhedra.edge); }, block.polyhedra);
}

void name_twins(std::span<const HalfEdge> twins, BlockMatesOf<Owned>& mates) {
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

} // namespace

struct BlockLinker::Pending {
    struct InRing {
        Index block, local;
        Index before; // index in `ring` of the previous block with the vertex, or none
    };
    struct Step {
        Index local; // a border vertex of this block
        Index block; // the next block in the ring of the vertex
        Index there; // local id of the vertex in the next block
    };
    struct OpenFace {
        Index face, tail;
        PlaceInFace anchor;
        Index steps; // BuiltBlock::Tail::steps
    };

    std::vector<CellType> types; // of the standard sections
    Index ghost_vertices = 0;
    bool needs_around = true, needs_mates = true;

    BlockAroundOf<Owned> around;
    std::vector<Index> ring_end; // by owned vertex: index in `ring` of the last later block with the vertex, or none
    std::vector<InRing> ring;
    std::vector<Step> border;
    std::size_t open_vertices = 0;   // number of vertices that a later block may have
    std::size_t open_neighbours = 0; // number of blocks in `border` whose border vertices are not yet known

    BlockMatesOf<Owned> mates;
    std::vector<OpenFace> faces; // faces whose other cell is in a later block, ascending
    std::vector<HalfEdge> twins;
    std::size_t open_faces = 0;

    // Throws Error if complete_border has already freed ring_end, because the mesh's arrays have changed meanwhile.
    [[nodiscard]] Index& ring_end_of(Index own_vertex) {
        if (own_vertex >= ring_end.size()) refuse("two faces of it contradict each other");
        return ring_end[own_vertex];
    }
};

BlockLinker::BlockLinker(std::span<const Index> last_cell) : last_cell_(last_cell) {}
BlockLinker::~BlockLinker() = default;

BlockLinker::Pending& BlockLinker::pending(Index b) {
    if (b >= pending_.size() || !pending_[b]) refuse("two faces or vertices of it contradict each other");
    return *pending_[b];
}

std::vector<BlockLinker::CompleteRecord> BlockLinker::add(BuiltBlock&& built) {
    const auto b = static_cast<Index>(pending_.size());
    BlockOf<Owned>& block = built.block;
    cell_end_ = block.cell_begin + block.cell_count;
    block.vertex_begin = static_cast<Index>(slots_);
    slots_ += block.vertex_count;
    half_edges_ += block.half_edge_count;
    if (slots_ >= none)
        fail("the blocks of the mesh have more than 4,294,967,294 vertices together; split the dataset");
    numbers_.cell.push_back(block.cell_begin);
    numbers_.slot.push_back(block.vertex_begin);
    numbers_.half_edges.push_back(block.half_edge_count);
    numbers_.border_vertices.push_back(0);
    own_vertices(built);

    Pending& kept = *pending_.emplace_back(std::make_unique<Pending>());
    border_.emplace_back();
    waiting_.emplace_back();
    for (const StandardSectionOf<Owned>& section : block.standard) kept.types.push_back(section.shape->type);
    kept.ghost_vertices = static_cast<Index>(block.ghost_vertex.size());
    kept.around = std::move(built.around);
    kept.mates = std::move(built.mates);
    kept.ring_end.assign(built.vertices.size() - kept.ghost_vertices, none);
    kept.open_vertices = built.vertices.size();

    std::vector<Index> renumbered = own_edges(built);
    BlockGhosts ghosts = name_ghosts(block, numbers_.vertex, numbers_.edge);
    join_twins(built);
    share_vertices(built);
    auto cells = std::make_shared<BlockOf<Owned>>(std::move(block));
    complete_.push_back(
        {b, RecordKind::cells, [b, cells, ghosts = std::move(ghosts), renumbered = std::move(renumbered)] {
             renumber_edges(*cells, renumbered);
             return record_of(*cells, ghosts, b);
         }});
    return std::exchange(complete_, {});
}

void BlockLinker::finish() {
    const auto is_pending = [](const auto& pending) { return pending != nullptr; };
    if (std::ranges::any_of(pending_, is_pending)) refuse("a face of it has a second cell that does not have the face");
    if (pending_.empty()) return;
    numbers_.cell.push_back(cell_end_);
    numbers_.vertex.push_back(vertices_);
    numbers_.edge.push_back(static_cast<Index>(edges_));
    numbers_.slot.push_back(static_cast<Index>(slots_));
}

// Vertices are numbered by first use, so the vertices that a block owns have consecutive ids.
void BlockLinker::own_vertices(BuiltBlock& built) {
    BlockOf<Owned>& block = built.block;
    block.own_vertex_begin = vertices_;
    numbers_.vertex.push_back(vertices_);
    const auto first = std::ranges::lower_bound(built.vertices, vertices_);
    block.ghost_vertex.assign(built.vertices.begin(), first);
    for (auto v = first; v != built.vertices.end(); ++v)
        if (*v != vertices_++) refuse("its vertices are not in the order of their first use");
}

void BlockLinker::share_vertices(const BuiltBlock& built) {
    const auto b = static_cast<Index>(pending_.size() - 1);
    Index owner = 0;
    for (Index local = 0; local < built.vertices.size(); ++local) {
        const Index vertex = built.vertices[local];
        if (local >= built.block.ghost_vertex.size()) {
            owner = b;
        } else {
            if (owner + 1 < numbers_.vertex.size() && vertex >= numbers_.vertex[owner + 1])
                owner = block_with(vertex, numbers_.vertex);
            Pending& owning = pending(owner);
            Index& end = owning.ring_end_of(vertex - numbers_.vertex[owner]);
            owning.ring.push_back({b, local, std::exchange(end, static_cast<Index>(owning.ring.size()))});
        }
        if (!is_open(vertex)) close_vertex(vertex, owner);
    }
    if (built.vertices.empty()) complete_border(b); // the cells of the block have no faces
}

void BlockLinker::close_vertex(Index vertex, Index owner) {
    Pending& owning = pending(owner);
    const Index own = vertex - numbers_.vertex[owner];
    Index next_block = owner, next_local = owning.ghost_vertices + own;
    const Index end = owning.ring_end_of(own);
    const bool is_shared = end != none;
    const auto leave = [&](Index block, Index local) {
        Pending& at = pending(block);
        if (is_shared) at.border.push_back({local, next_block, next_local});
        next_block = block;
        next_local = local;
        if (--at.open_vertices == 0) complete_border(block);
    };
    // Goes from the last block back to the owner, because InRing::before links the entries in this direction.
    std::vector<std::pair<Index, Index>> later;
    for (Index i = end; i != none; i = owning.ring[i].before)
        later.emplace_back(owning.ring[i].block, owning.ring[i].local);
    for (const auto& [block, local] : later) leave(block, local);
    leave(owner, owning.ghost_vertices + own);
}

void BlockLinker::complete_border(Index b) {
    Pending& kept = pending(b);
    kept.ring = {};
    kept.ring_end = {};
    std::ranges::sort(kept.border, {}, &Pending::Step::local);
    for (const Pending::Step& step : kept.border) {
        border_[b].push_back(step.local);
        kept.around.neighbour.push_back(step.block);
    }
    border_[b].shrink_to_fit();
    numbers_.border_vertices[b] = static_cast<Index>(border_[b].size());
    sort_once(kept.around.neighbour);
    for (const Index next : kept.around.neighbour)
        if (border_[next].empty()) {
            waiting_[next].push_back(b);
            ++kept.open_neighbours;
        }
    if (kept.open_neighbours == 0) complete_around(b);
    for (const Index waiting : std::exchange(waiting_[b], {}))
        if (--pending(waiting).open_neighbours == 0) complete_around(waiting);
}

void BlockLinker::complete_around(Index b) {
    Pending& kept = pending(b);
    std::visit(
        [&](auto& arrays) {
            using Local = std::decay_t<decltype(arrays.border_vertex[0])>;
            arrays.border_vertex.assign(border_[b].begin(), border_[b].end());
            for (const Pending::Step& step : kept.border) {
                arrays.border_block.push_back(static_cast<Local>(place_in(kept.around.neighbour, step.block)));
                const Index place = place_in(border_[step.block], step.there);
                if (place > std::numeric_limits<Local>::max())
                    fail("a cell shares more than 65,536 vertices with other cells; split the cell");
                arrays.border_place.push_back(static_cast<Local>(place));
            }
        },
        kept.around.arrays);
    auto around = std::make_shared<const BlockAroundOf<Owned>>(std::move(kept.around));
    complete_.push_back(
        {b, RecordKind::around, [b, around, types = kept.types] { return record_of(*around, types, b); }});
    kept.border = {};
    kept.needs_around = false;
    release(b);
}

// The edges that a block owns have consecutive ids. A ghost edge has the id that its owner assigns.
std::vector<Index> BlockLinker::own_edges(BuiltBlock& built) {
    BlockOf<Owned>& block = built.block;
    const auto ghost_vertices = static_cast<Index>(block.ghost_vertex.size());
    const auto ends = [&built](Index e) {
        return std::pair(built.vertices[built.edge_ends[e][0]], built.vertices[built.edge_ends[e][1]]);
    };
    std::vector<Index> shared; // edges that an earlier block may own
    for (Index e = 0; e < built.edge_ends.size(); ++e) {
        if (built.edge_ends[e][1] >= ghost_vertices) continue;
        shared.push_back(e);
        open_edges_.fetch(ends(e));
    }
    std::vector<std::pair<Index, Index>> ghosts; // (mesh-wide id, local id) of each ghost edge
    std::vector<Index> renumbered(built.edge_ends.size(), 0);
    for (const Index e : shared)
        if (const Index known = open_edges_.find(ends(e)); known != none) ghosts.emplace_back(known, e);
    std::ranges::sort(ghosts);
    for (const auto& [id, edge] : ghosts) {
        renumbered[edge] = none;
        block.ghost_edge.push_back(id);
    }
    block.edge_begin = static_cast<Index>(edges_);
    numbers_.edge.push_back(block.edge_begin);
    const auto is_open = [this](Index vertex) { return this->is_open(vertex); };
    std::vector<std::uint8_t> open(built.vertices.size()); // by local vertex
    std::ranges::transform(built.vertices, open.begin(), is_open);
    std::vector<std::pair<Index, Index>> left_open; // (local id, mesh-wide id) of edges that a later block may have
    for (Index e = 0; e < renumbered.size(); ++e) {
        if (renumbered[e] == none) continue;
        const auto [low, high] = built.edge_ends[e];
        if (open[low] != 0 && open[high] != 0) {
            left_open.emplace_back(e, static_cast<Index>(edges_));
            open_edges_.fetch(ends(e));
        }
        renumbered[e] = static_cast<Index>(ghosts.size() + edges_ - block.edge_begin);
        ++edges_;
    }
    for (const auto& [e, id] : left_open) open_edges_.add(ends(e), id, is_open);
    if (edges_ >= none) fail("the mesh has more than 4,294,967,294 edges; split the dataset");
    for (Index i = 0; i < ghosts.size(); ++i) renumbered[ghosts[i].second] = i;
    return renumbered;
}

void BlockLinker::join_twins(const BuiltBlock& built) {
    const auto b = static_cast<Index>(pending_.size() - 1);
    Pending& kept = *pending_[b];
    const auto tails = static_cast<Index>(built.tails.size());
    kept.twins.assign(tails, no_half_edge);
    for (Index i = 0; i < tails; ++i) {
        const BuiltBlock::Tail& tail = built.tails[i];
        if (tail.other_cell == none) continue;
        if (tail.mate != none) {
            kept.twins[i] = half_edge_in(b, turn(built.block, tail.mate, tail.steps));
            continue;
        }
        const PlaceInFace anchor = place_in_face(built.block, tail.anchor);
        if (tail.side == 0) {
            kept.faces.push_back({tail.face, i, anchor, tail.steps});
            continue;
        }
        const Index owner = block_with(tail.other_cell, numbers_.cell);
        Pending& owning = pending(owner);
        const auto open = std::ranges::lower_bound(owning.faces, tail.face, {}, &Pending::OpenFace::face);
        if (open == owning.faces.end() || open->face != tail.face || owner == b)
            refuse("a face of it has a first cell that does not have the face");
        kept.twins[i] = half_edge_in(owner, open->anchor.turned(tail.steps));
        owning.twins[open->tail] = half_edge_in(b, anchor.turned(open->steps));
        if (--owning.open_faces == 0) complete_mates(owner);
    }
    std::ranges::sort(kept.faces, {}, &Pending::OpenFace::face);
    kept.open_faces = kept.faces.size();
    if (kept.open_faces == 0) complete_mates(b);
}

void BlockLinker::complete_mates(Index b) {
    Pending& kept = pending(b);
    auto mates = std::make_shared<BlockMatesOf<Owned>>(std::move(kept.mates));
    complete_.push_back({b, RecordKind::mates, [b, mates, types = kept.types, twins = std::move(kept.twins)] {
                             name_twins(twins, *mates);
                             return record_of(*mates, types, b);
                         }});
    kept.faces = {};
    kept.needs_mates = false;
    release(b);
}

void BlockLinker::release(Index b) {
    if (!pending_[b]->needs_around && !pending_[b]->needs_mates) pending_[b] = nullptr;
}

} // namespace ciel::detail
