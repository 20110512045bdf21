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
    bool operator==(const SlabOfVolume&) const = default;
};

// From the back to the front of every ray through an eye at a place along the rows, infinite for parallel rays: rays
// run up on one side of the eye and down on the other. Of slabs of different thickness those go first whose middle is
// farther: half of a thick one's neighbours are in front of it and half behind. Of slabs with the same middle, whose
// light is mixed in the same place, now the first volume's is blended first and now the last one's, so that none is in
// front of the others.
[[nodiscard]] std::vector<SlabOfVolume> back_to_front(std::span<const SlabRow> rows, double eye);

} // namespace ciel::render
