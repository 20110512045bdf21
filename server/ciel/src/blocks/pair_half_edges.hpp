// Finds the mate of each half-edge within one cell, as Algorithm 5 does (paper, appendix A).
#pragma once

#include "blocks/block.hpp"

namespace ciel::detail {

// Handles the cells of many sections with the same buffers. Each thread needs its own object.
class HalfEdgePairs {
public:
    // Calls paired(half-edge, mate, index of the mate's face among the faces of the cell) for each half-edge of a cell.
    // Where a cell touches itself along an edge, any pairing of opposite directions is valid; pairs in different faces
    // are preferred. `left`: number of half-edges that this cell and all later cells may have together; the section's
    // half_edge_count before the first cell. Returns false if the cell is not closed or has more than `left`
    // half-edges.
    template <class Section, class Paired> // Section: a PolyhedralSection
    [[nodiscard]] bool run(const Section& section, Index cell, Index& left, Paired&& paired) {
        for (const Index edge : touched_) open_[edge] = none; // entries that a call left when it returned early
        waiting_.clear();
        touched_.clear();
        const auto faces = section.faces_of(cell);
        for (Index i = 0; i < faces.size(); ++i) {
            const Index ref = faces[i];
            const auto loop = section.loop(ref / 2);
            if (loop.size() > left) return false;
            left -= loop.size();
            for (Index k = loop.begin; k < loop.end; ++k) {
                const bool along_loop = section.vertex[k] < section.vertex[loop.next(k)];
                meet({section.half_edge(k, ref % 2), i, none, along_loop == (ref % 2 == 0)}, read_once(section.edge[k]),
                     paired);
            }
        }
        return pair_inside_faces(paired);
    }

private:
    struct Waiting {
        Index half_edge, face_of_cell, next; // next: index in waiting_ of the next unpaired half-edge of the edge
        bool upward;                         // the half-edge runs from the lower to the higher local vertex
    };

    template <class Paired>
    void meet(const Waiting& here, Index edge, Paired& paired) {
        if (edge >= open_.size()) open_.resize(edge + std::size_t{1}, none);
        Index* link = &open_[edge];
        if (*link == none) touched_.push_back(edge);
        while (*link != none &&
               (waiting_[*link].upward == here.upward || waiting_[*link].face_of_cell == here.face_of_cell))
            link = &waiting_[*link].next;
        if (*link == none) {
            waiting_.push_back(here);
            waiting_.back().next = open_[edge];
            open_[edge] = static_cast<Index>(waiting_.size() - 1);
            return;
        }
        const Waiting mate = waiting_[*link];
        *link = mate.next;
        paired(here.half_edge, mate.half_edge, mate.face_of_cell);
        paired(mate.half_edge, here.half_edge, here.face_of_cell);
    }

    // Pairs the remaining half-edges. Both half-edges of such a pair may be in the same face, if this face has
    // collapsed to a line. Returns false if a half-edge has no mate.
    template <class Paired>
    [[nodiscard]] bool pair_inside_faces(Paired& paired) {
        bool closed = true;
        for (const Index edge : touched_) {
            while (open_[edge] != none) {
                const Waiting here = waiting_[open_[edge]];
                Index* link = &waiting_[open_[edge]].next;
                while (*link != none && waiting_[*link].upward == here.upward) link = &waiting_[*link].next;
                if (*link == none) {
                    closed = false;
                    open_[edge] = none;
                    break;
                }
                const Waiting mate = waiting_[*link];
                *link = mate.next;
                open_[edge] = waiting_[open_[edge]].next;
                paired(here.half_edge, mate.half_edge, mate.face_of_cell);
                paired(mate.half_edge, here.half_edge, here.face_of_cell);
            }
        }
        return closed;
    }

    std::vector<Index> open_; // local edge -> index in waiting_ of its first unpaired half-edge, or none
    std::vector<Waiting> waiting_;
    std::vector<Index> touched_; // local edges of the cell
};

} // namespace ciel::detail
