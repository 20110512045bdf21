#include "ciel/local_numbers.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace ciel {

namespace {

constexpr std::size_t fewest_slots = 1024;

} // namespace

void LocalNumbers::begin(Index highest, std::size_t most) {
    const std::size_t window = std::min(std::size_t{highest} + 1, most);
    window_begin_ = static_cast<Index>(std::size_t{highest} + 1 - window);
    window_.assign(window, none);
    hashed_.assign(std::max(fewest_slots, hashed_.size()), {});
    used_ = 0;
}

bool LocalNumbers::add(Index id) {
    if (id >= window_begin_) {
        Index& number = window_[id - window_begin_];
        return std::exchange(number, number == none ? 0 : number) == none;
    }
    Slot& slot = hashed_[slot_of(id)];
    if (slot.id == id) return false;
    slot.id = id;
    if (2 * ++used_ > hashed_.size()) grow();
    return true;
}

// Fibonacci hashing (Knuth, The Art of Computer Programming 6.4): spreads the runs that ids come in.
std::size_t LocalNumbers::slot_of(Index id) const {
    const int shift = 32 - std::countr_zero(hashed_.size());
    std::size_t at = static_cast<Index>(id * 2654435769U) >> shift;
    while (hashed_[at].id != none && hashed_[at].id != id) at = (at + 1) % hashed_.size();
    return at;
}

void LocalNumbers::grow() {
    std::vector<Slot> before(2 * hashed_.size());
    before.swap(hashed_);
    for (const Slot& slot : before)
        if (slot.id != none) hashed_[slot_of(slot.id)] = slot;
}

} // namespace ciel
