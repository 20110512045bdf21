// Pairs the half-edges of one cell: the mates of Algorithm 5 (paper, appendix A). For the construction of a block, and
// for cuts of cells that touch themselves.
#pragma once

#include "blocks/block.hpp"

namespace ciel {

// Pairs the cells of many sections with the same buffers; one object per thread.
class HalfEdgePairs {
public:
    // Calls paired(half-edge, mate, index of the mate's face among the faces of the cell) for each half-edge of a cell.
    // If a cell touches itself along an edge, the edge has more than two half-edges in the cell. Then any pairing of
    // opposite directions is valid, and pairs in different faces are preferred. Returns false if a half-edge has no
    // mate, because the cell is not closed. `left`: number of half-edges that this cell and those after it may have.
    // Set it to the section's half_edge_count before the first cell. If a changed record names more, returns false.
    template <class Section, class Paired> // Section: a PolyhedralSection
    [[nodiscard]] bool run(const Section& section, Index cell, Index& left, Paired&& paired) {
        for (const Index edge : touched_) open_[edge] = none; // the last call may have ended early and left some
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
        Index half_edge, face_of_cell, next; // next: in the list of the edge
        bool upward;                         // the half-edge runs from the lower local vertex to the higher one
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

    // Pairs the half-edges that `meet` left unpaired. In a face that collapsed to a line, both half-edges of a pair may
    // be in that face.
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

    std::vector<Index> open_; // local edge -> first of its unpaired half-edges, in waiting_; none when a call begins
    std::vector<Waiting> waiting_;
    std::vector<Index> touched_; // local edges of the cell
};

} // namespace ciel
