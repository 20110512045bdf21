#include "store/cache/cache.hpp"

#include <iterator>
#include <utility>
#include <vector>

namespace server::store {

std::shared_ptr<const void> Cache::get_erased(const std::string& key, const std::function<Made()>& make) {
    const std::shared_ptr<Slot> mine = slot(key);
    const std::lock_guard making(mine->making);
    if (!mine->made.value) {
        mine->made = make();
        account(key, *mine);
    }
    return mine->made.value;
}

std::shared_ptr<Cache::Slot> Cache::slot(const std::string& key) {
    const std::lock_guard lock(mutex_);
    auto found = entries_.find(key);
    if (found == entries_.end()) {
        ages_.push_front(key);
        found = entries_.emplace(key, Entry{std::make_shared<Slot>(), ages_.begin(), 0}).first;
    } else {
        ages_.splice(ages_.begin(), ages_, found->second.age);
    }
    return found->second.slot;
}

void Cache::account(const std::string& key, const Slot& made) {
    std::vector<std::shared_ptr<Slot>> dropped; // destroyed after `lock`
    const std::lock_guard lock(mutex_);
    // If the entry was dropped while its value was being made, the cache does not hold the value and must not count it.
    if (const auto found = entries_.find(key); found != entries_.end() && found->second.slot.get() == &made) {
        found->second.bytes = made.made.bytes;
        bytes_ += made.made.bytes;
    }
    while ((bytes_ > budget_ || ages_.size() > most_) && ages_.size() > 1)
        dropped.push_back(drop(std::prev(ages_.end())));
}

std::shared_ptr<Cache::Slot> Cache::drop(std::list<std::string>::iterator key) {
    const auto entry = entries_.find(*key);
    std::shared_ptr<Slot> dropped = std::move(entry->second.slot);
    bytes_ -= entry->second.bytes;
    entries_.erase(entry);
    ages_.erase(key);
    return dropped;
}

// While mutex_ is locked, no other thread can get a reference to a slot or value that only the cache holds.
void Cache::drop_unused() {
    std::vector<std::shared_ptr<Slot>> dropped; // destroyed after `lock`
    const std::lock_guard lock(mutex_);
    for (auto key = ages_.begin(); key != ages_.end();) {
        const auto next = std::next(key);
        const std::shared_ptr<Slot>& slot = entries_.at(*key).slot;
        // A slot whose value could not be made (use_count() 0) is unused, too.
        if (key != ages_.begin() && slot.use_count() == 1 && slot->made.value.use_count() <= 1)
            dropped.push_back(drop(key));
        key = next;
    }
}

std::size_t Cache::bytes() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
}

} // namespace server::store
