// Maps the mesh-wide vertex ids of one block to local numbers. The memory does not grow with the size of the mesh. The
// vertices that a block owns have the highest ids of the block, without gaps; an array, the window, has their local
// numbers. The other ids are in a hash table. Not in the paper, which has no blocks.
#pragma once

#include "ciel/types.hpp"

#include <vector>

namespace ciel::detail {

// Not thread-safe. One object serves many blocks.
class LocalNumbers {
public:
    // Removes all ids. `highest`: highest id that will be added. `most`: maximum number of calls of `add`.
    void begin(Index highest, std::size_t most);
    void add(Index id) {
        if (id < window_begin_)
            add_hashed(id);
        else
            window_[id - window_begin_] = 0;
    }
    // Numbers the added ids from 0 in ascending order, and sets `ids` to the added ids in that order.
    void number(std::vector<Index>& ids);
    // REQUIRES: id was added
    [[nodiscard]] Index operator[](Index id) const {
        return id >= window_begin_ ? window_[id - window_begin_] : hashed_[slot_of(id)].number;
    }

private:
    struct Slot {
        Index id = none, number = 0;
    };
    [[nodiscard]] std::size_t slot_of(Index id) const; // index of `id` in hashed_, or of the free slot for it
    void add_hashed(Index id);
    void grow();

    Index window_begin_ = 0;
    std::vector<Index> window_; // local number of the id window_begin_ + i; none if it was not added
    std::vector<Slot> hashed_;  // hash table with open addressing; size is a power of two
    std::vector<Index> added_;  // ids in hashed_
};

} // namespace ciel::detail
