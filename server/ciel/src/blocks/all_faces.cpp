#include "blocks/blocks.hpp"
#include "blocks/cell_loops.hpp"
#include "ciel/cell_geometry.hpp"
#include "ciel/numbered_faces.hpp"
#include "ciel/parallel.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

namespace ciel {

using namespace detail;

namespace {

void add_face(std::span<const Index> loop, Index owner, Index neighbour, FaceLists& lists) {
    lists.face_vertex.insert(lists.face_vertex.end(), loop.begin(), loop.end());
    lists.face_offset.push_back(lists.face_vertex.size());
    lists.owner.push_back(owner);
    lists.neighbour.push_back(neighbour);
}

class InnerFacesOf {
public:
    InnerFacesOf(const Topology& topology, Index b) : topology_(topology), b_(b) {
        const Block& block = topology.blocks().cells(b);
        for (const StandardSection& section : block.standard) add(block, section);
        block.with([&](const auto& polyhedra) { add(block, polyhedra); });
    }

    // Calls f(loop, owner, neighbor) for each face with a neighbor and with its owner in the block, ascending by owner.
    template <class F>
    void for_each(F&& f) const {
        std::vector<Index> order(owner_.size());
        std::iota(order.begin(), order.end(), Index{0});
        std::ranges::stable_sort(order, {}, [this](Index i) { return owner_[i]; });
        for (const Index i : order) f(loops_.face(i), owner_[i], neighbour_[i]);
    }

private:
    void add(const Block& block, const StandardSection& section) {
        const StandardShape& shape = *section.shape;
        for (Index i = 0; i < section.count(); ++i) {
            const Index cell = block.cell(section.local_cell(i));
            for (std::size_t face = 0; face < shape.faces; ++face)
                if (owns(cell, section.half_edge_begin + i * shape.half_edges + shape.face_begin[face]))
                    add_face(block, section, i, face, loops_);
        }
    }
    template <class Local>
    void add(const Block& block, const PolyhedralSection<Local>& polyhedra) {
        std::size_t corners = 0;
        for (Index i = 0; i < polyhedra.count(); ++i) {
            const Index cell = block.cell(polyhedra.local_cell(i));
            for (const Local& entry : polyhedra.faces_of(i)) {
                const Index face_and_side = read_once(entry), side = face_and_side % 2;
                const auto loop = corners_of_face(polyhedra, face_and_side / 2);
                corners += loop.size();
                if (corners > polyhedra.half_edge_count()) refuse_changed("a cell has more corners than its block");
                if (loop.size() > 0 && owns(cell, polyhedra.half_edge_begin + polyhedra.half_edge(loop.begin, side)))
                    add_face(block, polyhedra, loop, side, loops_);
            }
        }
    }
    // If the face lies between two cells and `cell` is its owner (the lower id), appends both cells and returns true.
    bool owns(Index cell, Index half_edge) {
        const HalfEdge mate = topology_.mate_polyhedron(half_edge_in(b_, half_edge));
        if (mate == no_half_edge) return false;
        const Index other = topology_.cell(mate);
        if (other <= cell) return false;
        owner_.push_back(cell);
        neighbour_.push_back(other);
        return true;
    }

    const Topology& topology_;
    Index b_;
    CellLoops loops_;
    std::vector<Index> owner_, neighbour_; // by face
};

} // namespace

FaceLists all_faces(const Topology& topology, const FaceMeshView& boundary) {
    const Index blocks = topology.block_count();
    FaceLists lists;
    Index next = 0; // next face of `boundary` to add
    std::vector<Index> loop;
    const auto add_boundary_to = [&](Index cell) {
        for (; next < boundary.face_count() && boundary.owner[next] <= cell; ++next) {
            if (boundary.neighbour[next] != none) continue;
            read_loop(boundary, next, loop);
            add_face(loop, boundary.owner[next], none, lists);
        }
    };
    constexpr Index at_once = 64; // blocks searched at a time; limits the memory for found faces
    for (Index first = 0; first < blocks; first += at_once) {
        std::array<std::optional<InnerFacesOf>, at_once> found;
        parallel_for(std::min(at_once, blocks - first), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) found[i].emplace(topology, first + static_cast<Index>(i));
        });
        for (const std::optional<InnerFacesOf>& of_block : found)
            if (of_block)
                of_block->for_each([&](std::span<const Index> inner, Index owner, Index neighbour) {
                    add_boundary_to(owner);
                    add_face(inner, owner, neighbour, lists);
                });
    }
    add_boundary_to(none);
    return lists;
}

} // namespace ciel
