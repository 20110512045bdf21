// Winding of one polyhedron: are its faces closed, do they agree, is the whole outward (paper, appendix A: half-edges
// find their mates through the incident lists of their end points).
#pragma once

#include "ciel/assemble.hpp"

#include <optional>

namespace ciel {

// Scratch for many cells, one per thread; borrows the input, whose arrays have the right sizes. Throws nothing: what is
// bad is told.
class CellWinding {
public:
    explicit CellWinding(const PolyhedraView& input);

    struct Verdict {
        std::optional<BadCells::Reason> bad;
        double volume = 0; // after turning: never negative
        Vec3d centre{};    // mean of the corners
    };
    // `turn[f]` is set to 1 for each input face of the cell that has to be reversed, else 0.
    Verdict judge(Index cell, std::span<std::uint8_t> turn);

    // The parts of a closed cell that could be turned one by one without opening it: where it touches itself along an
    // edge, or around a cavity. One number per face of the cell, less than there are faces; equal ones are of one part.
    [[nodiscard]] std::vector<Index> lobes(Index cell);

private:
    struct Face {
        std::uint64_t id;
        Index begin, end; // in from_
        bool turned = false;
    };

    bool gather(Index cell); // false when an index is out of range
    void forget();
    bool balanced();
    bool balanced_when_sorted(); // the same; overwrites uses_
    std::optional<BadCells::Reason> make_agree();
    bool collect_edges();
    Index spread_winding();
    void join_open_lobes(Index count);
    Index joined(Index lobe);
    [[nodiscard]] Index target(Index half_edge) const;
    [[nodiscard]] Vec3d position(Index local) const;
    [[nodiscard]] Vec3d centre() const;
    [[nodiscard]] double signed_volume(const Vec3d& centre) const;

    const PolyhedraView& input_;
    std::vector<Index> local_of_; // input vertex -> local, none for vertices of no current interest
    std::vector<Index> vertices_; // local -> input vertex
    std::vector<Face> faces_;     // loops as they are in from_
    std::vector<Index> from_;     // local origin of each half-edge; the target is the next one's origin
    std::vector<Index> face_of_;  // half-edge -> face
    std::vector<Index> loop_;     // one face, input vertices
    std::vector<Index> head_;     // local vertex -> first half-edge of its list
    std::vector<Index> next_;     // half-edge -> next of the same list
    std::vector<std::uint8_t> paired_;
    std::vector<Index> lobe_;      // face -> faces that hang together by edges of two faces
    std::vector<Index> joined_to_; // lobe -> one that it goes with, itself at the end
    struct Use {
        Index low, high, face;
        bool upward;
    };
    std::vector<Use> uses_; // half-edges by edge
    Index lobe_at(const Use& use) { return joined(lobe_[use.face]); }
    struct Neighbour {
        Index face;
        bool same_direction;
    };
    std::vector<std::vector<Neighbour>> neighbours_; // face -> faces across an edge that only the two share
};

} // namespace ciel
