// Mesh ids of one block -> local numbers, in memory that grows with the block and not with the mesh. A block's own
// vertices are consecutive and the highest that it has, so most ids lie in a window that is an array; the others are
// hashed. Not in the paper, whose half-edges are not in blocks.
#pragma once

#include "ciel/types.hpp"

#include <vector>

namespace ciel {

// One thread at a time; used again for many blocks.
class LocalNumbers {
public:
    // Forgets all. `highest`: that will be added; `most`: so many will be added at most, each counted as often as add
    // is called.
    void begin(Index highest, std::size_t most);
    void add(Index id) {
        if (id < window_begin_)
            add_hashed(id);
        else
            window_[id - window_begin_] = 0;
    }
    // Numbers what was added, from 0 on, by ascending ids, and lists these.
    void number(std::vector<Index>& ids);
    // REQUIRES: id was added
    [[nodiscard]] Index operator[](Index id) const {
        return id >= window_begin_ ? window_[id - window_begin_] : hashed_[slot_of(id)].number;
    }

private:
    struct Slot {
        Index id = none, number = 0;
    };
    [[nodiscard]] std::size_t slot_of(Index id) const; // where it is, or would be
    void add_hashed(Index id);
    void grow();

    Index window_begin_ = 0;
    std::vector<Index> window_; // none where it was not added
    std::vector<Slot> hashed_;  // a power of two; at least half of them are free
    std::vector<Index> added_;  // of those hashed
};

} // namespace ciel
