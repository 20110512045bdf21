#include "blocks/local_numbers.hpp"

#include <algorithm>
#include <bit>

namespace ciel::detail {

namespace {

constexpr std::size_t fewest_slots = 1024;

} // namespace

void LocalNumbers::begin(Index highest, std::size_t most) {
    const std::size_t window = std::min(std::size_t{highest} + 1, most);
    window_begin_ = static_cast<Index>(std::size_t{highest} + 1 - window);
    window_.assign(window, none);
    hashed_.assign(std::max(fewest_slots, hashed_.size()), {});
    added_.clear();
}

void LocalNumbers::add_hashed(Index id) {
    Slot& slot = hashed_[slot_of(id)];
    if (slot.id == id) return;
    slot.id = id;
    added_.push_back(id);
    if (2 * added_.size() > hashed_.size()) grow();
}

void LocalNumbers::number(std::vector<Index>& ids) {
    std::ranges::sort(added_);
    ids = added_;
    for (Index local = 0; local < ids.size(); ++local) hashed_[slot_of(ids[local])].number = local;
    for (std::size_t i = 0; i < window_.size(); ++i) {
        if (window_[i] == none) continue;
        window_[i] = static_cast<Index>(ids.size());
        ids.push_back(window_begin_ + static_cast<Index>(i));
    }
}

// Fibonacci hashing (Knuth, The Art of Computer Programming 6.4) spreads runs of consecutive ids.
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

} // namespace ciel::detail
