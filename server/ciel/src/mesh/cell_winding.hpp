// Winding of one polyhedron: whether it is closed, whether its faces agree, whether it points outward (paper, appendix
// A: half-edges find their mates through the incident lists of their end points).
#pragma once

#include "ciel/assemble.hpp"

#include <optional>

namespace ciel {

// Scratch for many cells, one per thread. Borrows the input, whose arrays must have the right sizes. Bad cells never
// throw; they get a Verdict.
class CellWinding {
public:
    explicit CellWinding(const PolyhedraView& input);

    struct Verdict {
        std::optional<BadCells::Reason> bad;
        double volume = 0; // absolute value
        Vec3d centre{};    // mean of the corners
    };
    // Sets `turn[f]` to 1 for each input face of the cell that must be reversed, else to 0.
    Verdict judge(Index cell, std::span<std::uint8_t> turn);

    // The parts of a closed cell that can be reversed one by one without opening it. A cell has several where it
    // touches itself along an edge or surrounds a cavity. Returns one part number per face of the cell, each below the
    // number of faces.
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
    std::vector<Index> local_of_; // input vertex -> local; none for vertices of other cells
    std::vector<Index> vertices_; // local -> input vertex
    std::vector<Face> faces_;     // loops as they are in from_
    std::vector<Index> from_;     // local origin of each half-edge; the target is the next one's origin
    std::vector<Index> face_of_;  // half-edge -> face
    std::vector<Index> loop_;     // one face, input vertices
    std::vector<Index> head_;     // local vertex -> first half-edge of its list
    std::vector<Index> next_;     // half-edge -> next of the same list
    std::vector<std::uint8_t> paired_;
    std::vector<Index> lobe_;      // face -> lobe: faces connected by edges that exactly two faces share
    std::vector<Index> joined_to_; // lobe -> parent in the union; a root is its own parent
    struct Use {
        Index low, high, face;
        bool upward;
    };
    std::vector<Use> uses_; // half-edges sorted by edge
    Index lobe_at(const Use& use) { return joined(lobe_[use.face]); }
    struct Neighbour {
        Index face;
        bool same_direction;
    };
    std::vector<std::vector<Neighbour>> neighbours_; // face -> faces across an edge that no third face shares
};

} // namespace ciel
