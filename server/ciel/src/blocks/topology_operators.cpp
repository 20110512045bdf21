// The paper's six operators (section 2.2) on the layout of blocks.hpp.
#include "blocks/blocks.hpp"

#include <algorithm>
#include <string>

namespace ciel {

using namespace detail;

namespace {

// A half-edge of a standard section: index of its cell in the section, and its number in the shape.
struct InCell {
    Index cell, half_edge;
};

// Divides by a compile-time constant for each shape, because the division is most of the work of an operator.
InCell in_cell(const StandardSection& section, Index local_half_edge) {
    InCell place{};
    const Index at = local_half_edge - section.half_edge_begin;
    with_shape(section.shape->type, [&]<const StandardShape & shape>() {
        place = {at / shape.half_edges, at % shape.half_edges};
    });
    return place;
}

// Returns the first half-edge that leaves the vertex at `entry`. At a corner of a stored loop, it runs along the loop,
// or against the loop if only side 1 of the face is in the section. If a record has changed, it may not exist.
Index first_at_entry(const Block& block, Index entry) {
    if (const std::size_t s = block.section_of_entry(entry); s < block.standard.size()) {
        const StandardSection& section = block.standard[s];
        const StandardShape& shape = *section.shape;
        const Index i = (entry - section.entry_begin) / shape.corners;
        return section.half_edge_begin + i * shape.half_edges +
               shape.first_at_corner[(entry - section.entry_begin) % shape.corners];
    }
    return block.with([&](const auto& polyhedra) {
        const Index corner = entry - polyhedra.entry_begin;
        if (corner >= polyhedra.vertex.size())
            refuse_changed("a list of entries leads to an entry that does not exist");
        const bool far = corner >= polyhedra.far_corner;
        return polyhedra.half_edge_begin +
               polyhedra.half_edge(far ? polyhedra.previous_in_loop(corner, polyhedra.face(corner)) : corner,
                                   far ? 1 : 0);
    });
}

} // namespace

Index Topology::vertex(HalfEdge h) const {
    const Blocks::Place at = blocks_->place_of(h);
    const Block& block = at.block;
    const Index local = at.local;
    if (const std::size_t s = block.section_of_half_edge(local); s < block.standard.size()) {
        const StandardSection& section = block.standard[s];
        const auto [i, k] = in_cell(section, local);
        return block.vertex(section.vertex[i * section.shape->corners + section.shape->target(k)]);
    }
    return block.with([&](const auto& polyhedra) {
        const Index of_section = local - polyhedra.half_edge_begin, corner = polyhedra.corner(of_section);
        return block.vertex(
            polyhedra.vertex[polyhedra.side(of_section) == 1 ? corner
                                                             : polyhedra.next_in_loop(corner, polyhedra.face(corner))]);
    });
}

Index Topology::edge(HalfEdge h) const {
    const Blocks::Place at = blocks_->place_of(h);
    const Block& block = at.block;
    const Index local = at.local;
    if (const std::size_t s = block.section_of_half_edge(local); s < block.standard.size()) {
        const StandardSection& section = block.standard[s];
        const auto [i, k] = in_cell(section, local);
        return block.edge_id(section.edge[i * section.shape->edges + section.shape->edge[k]]);
    }
    return block.edge_id(block.with([&](const auto& polyhedra) {
        return Index{polyhedra.edge[polyhedra.corner(local - polyhedra.half_edge_begin)]};
    }));
}

HalfEdge Topology::next_around_face(HalfEdge h) const {
    const Blocks::Place at = blocks_->place_of(h);
    return half_edge_in(at.number, turn(at.block, at.local, 1));
}

HalfEdge Topology::mate_face(HalfEdge h) const {
    const Blocks::Place at = blocks_->place_of(h);
    const Block& block = at.block;
    const Index b = at.number, local = at.local;
    if (const std::size_t s = block.section_of_half_edge(local); s < block.standard.size()) {
        const StandardSection& section = block.standard[s];
        const Index k = in_cell(section, local).half_edge;
        return half_edge_in(b, local - k + section.shape->mate[k]);
    }
    const Index mate = with_mates(block, blocks_->mates(b), [&](const auto& polyhedra, const auto& mates) {
        const Index found = mates.mate(polyhedra, local - polyhedra.half_edge_begin);
        return found < polyhedra.half_edge_count() ? polyhedra.half_edge_begin + found : none;
    });
    if (mate == none)
        fail("block " + std::to_string(b) + " of the mesh is damaged: a mate is not found; import the dataset again");
    return half_edge_in(b, mate);
}

// Only the mate of a face's first half-edge is stored. The mates of the next half-edges precede this mate in its face.
HalfEdge Topology::mate_polyhedron(HalfEdge h) const {
    const Blocks::Place at = blocks_->place_of(h);
    const Block& block = at.block;
    const Index b = at.number, local = at.local;
    const BlockMates& mates = blocks_->mates(b);
    if (const std::size_t s = block.section_of_half_edge(local); s < block.standard.size()) {
        const StandardShape& shape = *block.standard[s].shape;
        const auto [i, k] = in_cell(block.standard[s], local);
        const Index mate = read_once(mates.mate[s][i * shape.faces + shape.face[k]]);
        if (mate == no_mate) return no_half_edge;
        const HalfEdge first =
            mate < block.standard_half_edges ? half_edge_in(b, mate) : mates.twin(mate - block.standard_half_edges);
        if (first == no_half_edge) return first;
        const Index steps = k - shape.face_begin[shape.face[k]], n = shape.face_size(shape.face[k]);
        return blocks_->turn_back(first, steps, n);
    }
    return block.with([&](const auto& polyhedra) {
        const Index of_section = local - polyhedra.half_edge_begin;
        if (of_section < 2 * polyhedra.inner_corners)
            return half_edge_in(b, polyhedra.half_edge_begin + (of_section ^ 1U));
        const Index corner = polyhedra.corner(of_section), face = polyhedra.face(corner);
        const HalfEdge first = mates.twin(mates.twin_begin + face - polyhedra.inner_faces);
        const auto loop = polyhedra.loop(face);
        const Index n = loop.size(), along = corner - loop.begin; // position along the stored loop
        return first == no_half_edge
                   ? first
                   : blocks_->turn_back(first, polyhedra.side(of_section) == 0 ? along : n - along, n);
    });
}

// Walks the vertex's list of entries (block.hpp). A corner of a standard cell gives the half-edges of the cell that
// leave it. A corner of an inner face gives the half-edge along the stored loop, then the one against it. A corner of a
// face with one side in the section gives only one of the two.
HalfEdge Topology::next_around_vertex(HalfEdge h) const {
    const Blocks::Place at = blocks_->place_of(h);
    const Block& block = at.block;
    const Index b = at.number, local = at.local;
    if (const std::size_t s = block.section_of_half_edge(local); s < block.standard.size()) {
        const StandardSection& section = block.standard[s];
        const StandardShape& shape = *section.shape;
        const auto [i, k] = in_cell(section, local);
        if (shape.next_at_corner[k] != StandardShape::end_of_list)
            return half_edge_in(b, local - k + shape.next_at_corner[k]);
        const Index corner = i * shape.corners + shape.origin[k];
        return blocks_->first_after(b, read_once(blocks_->around(b).next_entry[s][corner]), section.vertex[corner]);
    }
    return with_around(block, blocks_->around(b), [&](const auto& polyhedra, const auto& around) {
        const Index of_section = local - polyhedra.half_edge_begin;
        const Index segment = polyhedra.corner(of_section), side = polyhedra.side(of_section);
        const Index face = polyhedra.face(segment);
        const Index corner = side == 0 ? segment : polyhedra.next_in_loop(segment, face);
        if (side == 0 && segment < polyhedra.inner_corners)
            return half_edge_in(b, polyhedra.half_edge_begin +
                                       polyhedra.half_edge(polyhedra.previous_in_loop(corner, face), 1));
        return blocks_->first_after(b, read_once(around.next_entry[corner]), polyhedra.vertex[corner]);
    });
}

HalfEdge Topology::half_edge_of_vertex(Index vertex) const {
    const BlockVertex first = blocks_->first_with(vertex);
    if (first.block == none) return no_half_edge;
    const HalfEdge h = blocks_->first_at(first);
    return h != no_half_edge ? h : blocks_->first_after_block(first);
}

Index Topology::cell(HalfEdge h) const {
    const Blocks::Place at = blocks_->place_of(h);
    const Block& block = at.block;
    const Index local = at.local;
    if (const std::size_t s = block.section_of_half_edge(local); s < block.standard.size())
        return block.cell(block.standard[s].local_cell(in_cell(block.standard[s], local).cell));
    return block.cell(block.with([&](const auto& polyhedra) {
        const Index of_section = local - polyhedra.half_edge_begin;
        const Index face = polyhedra.face(polyhedra.corner(of_section));
        return polyhedra.local_cell(polyhedra.face_cell[face][polyhedra.side(of_section)]);
    }));
}

HalfEdge Topology::half_edge_begin(Index cell) const {
    const std::vector<HalfEdge> all = half_edges(cell);
    return all.empty() ? no_half_edge : all.front();
}

std::vector<HalfEdge> Topology::half_edges(Index cell) const {
    const Index b = blocks_->block_of_cell(cell);
    const Block& block = blocks_->cells(b);
    std::vector<HalfEdge> out;
    const auto place = [local = cell - block.cell_begin](const auto& section) {
        if (section.cell.empty()) return local < section.count() ? local : none;
        const auto found = std::ranges::lower_bound(section.cell, local);
        return found != section.cell.end() && *found == local ? static_cast<Index>(found - section.cell.begin()) : none;
    };
    for (const StandardSection& section : block.standard) {
        const Index i = place(section), n = section.shape->half_edges;
        if (i == none) continue;
        for (Index k = 0; k < n; ++k) out.push_back(half_edge_in(b, section.half_edge_begin + i * n + k));
        return out;
    }
    block.with([&](const auto& polyhedra) {
        const Index i = place(polyhedra);
        if (i == none) return;
        const Index most = polyhedra.half_edge_count();
        for (const Index ref : polyhedra.faces_of(i)) {
            const auto loop = polyhedra.loop(ref / 2);
            for (Index k = loop.begin; k < loop.end; ++k) {
                const Index h = polyhedra.half_edge(k, ref % 2);
                if (h >= most || out.size() == most) refuse_changed("a cell has a half-edge that does not exist");
                out.push_back(half_edge_in(b, polyhedra.half_edge_begin + h));
            }
        }
    });
    return out;
}

BlockVertex Topology::Blocks::first_with(Index vertex) const {
    if (numbers.vertex.empty() || vertex >= numbers.vertex.back()) return {none, none};
    const auto b = static_cast<Index>(std::ranges::upper_bound(numbers.vertex, vertex) - numbers.vertex.begin() - 1);
    return {b, static_cast<Index>(cells(b).ghost_vertex.size()) + vertex - numbers.vertex[b]};
}

HalfEdge Topology::Blocks::first_at(BlockVertex at) const {
    const Index entry = around(at.block).with([&](const auto& all) {
        const Index first = read_once(all.first_entry[at.vertex]);
        return first == all.end_of_list ? none : first;
    });
    return entry == none ? no_half_edge : half_edge_in(at.block, first_at_entry(cells(at.block), entry));
}

HalfEdge Topology::Blocks::first_after(Index b, Index entry, Index local_vertex) const {
    const bool at_end = around(b).with([&](const auto& all) { return entry == Index{all.end_of_list}; });
    return at_end ? first_after_block({b, local_vertex}) : half_edge_in(b, first_at_entry(cells(b), entry));
}

HalfEdge Topology::Blocks::first_after_block(BlockVertex start) const {
    const Index place = around(start.block).border_place_of(start.vertex);
    if (place == none) return first_at(start);
    BorderVertex at{start.block, place};
    do {
        at = next_in_ring(at, start.block);
        const HalfEdge h = first_at({at.block, vertex_at(at)});
        if (h != no_half_edge) return h;
    } while (at.block != start.block);
    return no_half_edge;
}

HalfEdge Topology::Blocks::turn_back(HalfEdge h, Index steps, Index face_size) const {
    const Place at = place_of(h);
    return half_edge_in(at.number, turn(at.block, at.local, face_size - steps));
}

void Topology::Blocks::refuse_half_edge() {
    fail("a half-edge does not exist in this mesh; pass one that this mesh returned. If it did, the mesh is damaged; "
         "import the dataset again");
}

} // namespace ciel
