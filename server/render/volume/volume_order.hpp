// In which order the slabs of volumes that lie in one another are blended.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ciel::render {

struct SlabRow { // of one volume: slab i begins at first + i * thickness
    double first = 0, thickness = 1;
    std::size_t count = 0;
};

struct SlabOfVolume {
    std::size_t volume = 0, slab = 0;
    double share = 1; // of what it loses and shines
    bool operator==(const SlabOfVolume&) const = default;
};

// Into how many slabs may be divided where they lie in each other: so many per length, but no more than `most` of what
// is between two borders of slabs.
struct SlabPieces {
    double per_length = 0;
    std::size_t most = 1;
};

// From the back to the front of every ray through an eye at a place along the rows, infinite for parallel rays: rays
// run up on one side of the eye and down on the other. Of
// slabs of different thickness those go first whose middle is farther: half of a thick one's neighbours are in front of
// it and half behind. Of slabs with the same middle, whose light is mixed in the same place, now the first volume's is
// blended first and now the last one's, so that none is in front of the others.
// Where slabs take so much light that this shows, they are divided at each other's borders and into pieces, and those
// take turns: what is left of the order goes with the square of a piece. After G. Strang, "On the construction and
// comparison of difference schemes", SIAM J. Numer. Anal. 5, 1968. Pieces that follow each other are one.
[[nodiscard]] std::vector<SlabOfVolume> back_to_front(std::span<const SlabRow> rows, double eye,
                                                      SlabPieces pieces = {});

} // namespace ciel::render
