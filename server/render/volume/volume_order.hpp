// Finds the order in which the slabs of overlapping volumes are blended.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace server::render {

struct SlabRow { // slabs of one volume; slab i begins at first + i * thickness
    double first = 0, thickness = 1;
    std::size_t count = 0;
};

struct SlabOfVolume {
    std::size_t volume = 0, slab = 0;
    double share = 1; // share of the slab's extinction and emission that is drawn at this position in the order
    bool operator==(const SlabOfVolume&) const = default;
};

// How slabs are divided: pieces per unit of length, and the largest number of pieces between two slab borders.
struct SlabPieces {
    double per_length = 0;
    std::size_t most = 1;
};

// Returns the slabs from back to front for every ray through the eye: first the slabs below the eye, in ascending
// order, then the slabs above the eye, in descending order. `eye`: coordinate of the eye along the slabs' normal,
// infinite for parallel rays. Slabs of different thickness are ordered by their middles. The light of coincident slabs
// mixes in the same space, so their order alternates from slab to slab. If the order would be visible, coincident slabs
// are divided into pieces that alternate. The error then decreases with the square of the length of the pieces: G.
// Strang, "On the construction and comparison of difference schemes", SIAM J. Numer. Anal. 5, 1968. Consecutive pieces
// of one slab are merged.
[[nodiscard]] std::vector<SlabOfVolume> back_to_front(std::span<const SlabRow> rows, double eye,
                                                      SlabPieces pieces = {});

} // namespace server::render
