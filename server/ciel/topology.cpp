#include "ciel/topology.hpp"

#include "ciel/block_links.hpp"
#include "ciel/parallel.hpp"

#include <algorithm>

namespace ciel {

namespace {

// Block boundaries (cells), so that each block but a giant cell's has local ids of 16 bits.
std::vector<Index> divide(const FaceMeshView& mesh, const CellFaces& faces, Index cells_per_block) {
    constexpr std::uint64_t half_edges_per_block = 65000;
    std::vector<Index> begin{0};
    std::uint64_t half_edges = 0;
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        std::uint64_t of_cell = 0;
        for (const Index f : faces.of(cell)) of_cell += mesh.loop(f).size();
        half_edges += of_cell;
        if (cell > begin.back() && (cell - begin.back() == cells_per_block || half_edges > half_edges_per_block)) {
            begin.push_back(cell);
            half_edges = of_cell;
        }
    }
    if (mesh.cell_count() > 0) begin.push_back(mesh.cell_count());
    return begin;
}

// Cells that hang together by faces.
std::uint64_t count_components(const FaceMeshView& mesh) {
    std::vector<Index> parent(mesh.cell_count());
    for (Index c = 0; c < parent.size(); ++c) parent[c] = c;
    const auto root = [&](Index c) {
        while (parent[c] != c) c = parent[c] = parent[parent[c]];
        return c;
    };
    std::uint64_t components = parent.size();
    for (Index f = 0; f < mesh.face_count(); ++f) {
        if (mesh.neighbour[f] == none) continue;
        const Index a = root(mesh.owner[f]), b = root(mesh.neighbour[f]);
        if (a == b) continue;
        parent[std::max(a, b)] = std::min(a, b);
        --components;
    }
    return components;
}

template <class T>
std::size_t bytes(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

std::size_t bytes_of(const Block& block) {
    return sizeof(Block) + bytes(block.vertex) + bytes(block.face_begin) + bytes(block.cell_face_begin) +
           bytes(block.ghost_edge) + bytes(block.tail_twin) + bytes(block.border_next) + block.with([](const auto& a) {
               return bytes(a.vertex) + bytes(a.face) + bytes(a.edge) + bytes(a.next_corner) + bytes(a.mate_face) +
                      bytes(a.first_corner) + bytes(a.edge_low) + bytes(a.edge_high) + bytes(a.cell_face) +
                      bytes(a.face_cell) + bytes(a.border_vertex);
           });
}

// The half-edge that leaves a corner's vertex along its loop, or the only one there is in another block's tail.
HalfEdge first_at_corner(const Topology::Blocks& blocks, Index b, Index corner) {
    const Block& block = blocks.block[b];
    if (corner < block.far_corner) return block.half_edge_begin + block.half_edge(corner, 0);
    const Index face = block.with([&](const auto& arrays) { return Index{arrays.face[corner]}; });
    return block.half_edge_begin + block.half_edge(block.previous_in_loop(corner, face), 1);
}

} // namespace

Topology::Topology(const FaceMeshView& mesh, Options options) : blocks_(std::make_unique<Blocks>()) {
    check_face_mesh(mesh);
    const CellFaces faces = cell_faces(mesh);
    const std::vector<Index> begin = divide(mesh, faces, std::max<Index>(1, options.cells_per_block));
    std::vector<BuiltBlock> built(begin.size() - 1);
    // Few tasks: each has a table as long as the vertices.
    parallel_for(built.size(), built.size() / (std::size_t{4} * thread_count()) + 1,
                 [&](std::size_t first, std::size_t last) {
                     BlockBuilder builder(mesh, faces);
                     for (std::size_t b = first; b < last; ++b) built[b] = builder.build(begin[b], begin[b + 1]);
                 });
    link_blocks(mesh, built, *blocks_);
    TopologyCounts& counts = blocks_->counts;
    counts.faces = mesh.face_count();
    counts.boundary_faces = static_cast<std::uint64_t>(std::ranges::count(mesh.neighbour, none));
    counts.cells = mesh.cell_count();
    counts.components = count_components(mesh);
}

Topology::~Topology() = default;
Topology::Topology(Topology&&) noexcept = default;
Topology& Topology::operator=(Topology&&) noexcept = default;

Index Topology::vertex(HalfEdge h) const {
    const Block& block = blocks_->block[blocks_->block_of(h)];
    const Index local = h - block.half_edge_begin, corner = block.corner(local);
    return block.with([&](const auto& arrays) {
        return block
            .vertex[arrays.vertex[block.side(local) == 1 ? corner : block.next_in_loop(corner, arrays.face[corner])]];
    });
}

Index Topology::edge(HalfEdge h) const {
    const Block& block = blocks_->block[blocks_->block_of(h)];
    const Index corner = block.corner(h - block.half_edge_begin);
    return block.edge_id(block.with([&](const auto& arrays) { return Index{arrays.edge[corner]}; }));
}

HalfEdge Topology::next_around_face(HalfEdge h) const {
    const Block& block = blocks_->block[blocks_->block_of(h)];
    const Index local = h - block.half_edge_begin, corner = block.corner(local), side = block.side(local);
    return block.with([&](const auto& arrays) {
        const Index face = arrays.face[corner];
        const Index next = side == 0 ? block.next_in_loop(corner, face) : block.previous_in_loop(corner, face);
        return block.half_edge_begin + block.half_edge(next, side);
    });
}

HalfEdge Topology::mate_face(HalfEdge h) const {
    const Block& block = blocks_->block[blocks_->block_of(h)];
    return block.half_edge_begin +
           block.with([&](const auto& arrays) { return Index{arrays.mate_face[h - block.half_edge_begin]}; });
}

HalfEdge Topology::mate_polyhedron(HalfEdge h) const {
    const Block& block = blocks_->block[blocks_->block_of(h)];
    const Index local = h - block.half_edge_begin;
    if (local < 2 * block.inner_corners) return block.half_edge_begin + (local ^ 1U);
    const Index corner = block.corner(local);
    const Index face = block.with([&](const auto& arrays) { return Index{arrays.face[corner]}; });
    const HalfEdge twin = block.tail_twin[face - block.inner_faces];
    return twin == none ? none : twin + (corner - block.face_begin[face]); // both tails keep the loop's corners
}

// At each corner of the vertex: the half-edge that leaves along the loop, then the one that leaves against it.
HalfEdge Topology::next_around_vertex(HalfEdge h) const {
    const Index b = blocks_->block_of(h);
    const Block& block = blocks_->block[b];
    const Index local = h - block.half_edge_begin, segment = block.corner(local), side = block.side(local);
    const BlockVertex next = block.with([&](const auto& arrays) -> BlockVertex {
        const Index face = arrays.face[segment];
        const Index corner = side == 0 ? segment : block.next_in_loop(segment, face);
        if (side == 0 && segment < block.inner_corners)
            return {none, block.half_edge(block.previous_in_loop(corner, face), 1)};
        if (arrays.next_corner[corner] != arrays.end_of_list) return {b, arrays.next_corner[corner]};
        const BlockVertex ring = blocks_->next_in_ring({b, arrays.vertex[corner]});
        return {ring.block, blocks_->block[ring.block].with(
                                [&](const auto& other) { return Index{other.first_corner[ring.vertex]}; })};
    });
    if (next.block == none) return block.half_edge_begin + next.vertex;
    return first_at_corner(*blocks_, next.block, next.vertex);
}

HalfEdge Topology::half_edge_of_vertex(Index vertex) const {
    if (blocks_->first_slot[vertex] == none) return none;
    const BlockVertex first = blocks_->at_slot(blocks_->first_slot[vertex]);
    const Index corner =
        blocks_->block[first.block].with([&](const auto& arrays) { return Index{arrays.first_corner[first.vertex]}; });
    return first_at_corner(*blocks_, first.block, corner);
}

Index Topology::cell(HalfEdge h) const {
    const Block& block = blocks_->block[blocks_->block_of(h)];
    const Index local = h - block.half_edge_begin;
    return block.cell_begin + block.with([&](const auto& arrays) {
        return Index{arrays.face_cell[arrays.face[block.corner(local)]][block.side(local)]};
    });
}

HalfEdge Topology::half_edge_begin(Index cell) const {
    const std::vector<HalfEdge> all = half_edges(cell);
    return all.empty() ? none : all.front();
}

std::vector<HalfEdge> Topology::half_edges(Index cell) const {
    const Block& block = blocks_->block[blocks_->block_of_cell(cell)];
    const Index local = cell - block.cell_begin;
    std::vector<HalfEdge> out;
    block.with([&](const auto& arrays) {
        for (Index i = block.cell_face_begin[local]; i < block.cell_face_begin[local + 1]; ++i)
            for (Index k = block.face_begin[arrays.cell_face[i] / 2]; k < block.face_begin[arrays.cell_face[i] / 2 + 1];
                 ++k)
                out.push_back(block.half_edge_begin + block.half_edge(k, arrays.cell_face[i] % 2));
    });
    return out;
}

const TopologyCounts& Topology::counts() const { return blocks_->counts; }
Index Topology::block_count() const { return static_cast<Index>(blocks_->block.size()); }

std::size_t Topology::memory_bytes() const {
    std::size_t sum =
        sizeof(Blocks) + bytes(blocks_->first_slot) + bytes(blocks_->block_at) + bytes(blocks_->edge_begin);
    for (const Block& block : blocks_->block) sum += bytes_of(block);
    return sum;
}

Index Topology::Blocks::block_of_cell(Index cell) const {
    const auto after = std::ranges::upper_bound(block, cell, {}, &Block::cell_begin);
    return static_cast<Index>(after - block.begin() - 1);
}

BlockVertex Topology::Blocks::at_slot(Index slot) const {
    const auto after = std::ranges::upper_bound(block, slot, {}, &Block::vertex_begin);
    return {static_cast<Index>(after - block.begin() - 1), slot - (after - 1)->vertex_begin};
}

BlockVertex Topology::Blocks::next_in_ring(BlockVertex at) const {
    const Block& from = block[at.block];
    return from.with([&](const auto& arrays) {
        const auto found = std::ranges::lower_bound(arrays.border_vertex, at.vertex);
        if (found == arrays.border_vertex.end() || *found != at.vertex) return at;
        return at_slot(from.border_next[static_cast<std::size_t>(found - arrays.border_vertex.begin())]);
    });
}

void Topology::Blocks::cells_around(Index vertex, std::vector<Index>& cells) const {
    cells.clear();
    if (first_slot[vertex] == none) return;
    const BlockVertex first = at_slot(first_slot[vertex]);
    BlockVertex at = first;
    do {
        const Block& here = block[at.block];
        const auto begin = static_cast<std::ptrdiff_t>(cells.size());
        here.with([&](const auto& arrays) {
            for (auto k = arrays.first_corner[at.vertex]; k != arrays.end_of_list; k = arrays.next_corner[k])
                for (const auto cell : arrays.face_cell[arrays.face[k]]) cells.push_back(here.cell_begin + cell);
        });
        std::sort(cells.begin() + begin, cells.end());
        cells.erase(std::unique(cells.begin() + begin, cells.end()), cells.end());
        at = next_in_ring(at);
    } while (at.block != first.block);
}

} // namespace ciel
