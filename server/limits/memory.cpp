#include "limits/memory.hpp"

#include "limits/errors.hpp"

#include <numeric>
#include <string>

namespace server::limits {

Memory::Memory(std::uint64_t most_bytes, std::function<std::uint64_t()> dataset_bytes, std::function<void()> release)
    : most_(most_bytes), dataset_bytes_(std::move(dataset_bytes)), release_(std::move(release)) {}

void Memory::Charge::change(std::size_t bytes) {
    if (bytes <= bytes_) return note(bytes);
    memory_.add_or_throw(held_, bytes - bytes_);
    bytes_ = bytes;
}

void Memory::Charge::note(std::size_t bytes) {
    memory_.replace(held_, bytes_, bytes);
    bytes_ = bytes;
}

void Memory::add_or_throw(Held held, std::uint64_t more) {
    if (add(held, more)) return;
    if (more <= most_) release_();
    if (!add(held, more)) throw LimitReached(refusal());
}

bool Memory::add(Held held, std::uint64_t more) {
    const std::uint64_t datasets = dataset_bytes_(); // called without mutex_, because it takes other locks
    const std::scoped_lock lock(mutex_);
    if (charged() + datasets + more > most_) return false;
    bytes_[static_cast<std::size_t>(held)] += more;
    return true;
}

std::string Memory::refusal() const {
    return "the server may hold " + std::to_string(most_ >> 20) + " MB for all its clients, and " +
           std::to_string((most_ - room()) >> 20) +
           " MB are in use. Show fewer layers or values, or try again when other clients have finished";
}

std::uint64_t Memory::room() const {
    const std::uint64_t datasets = dataset_bytes_();
    const std::scoped_lock lock(mutex_);
    const std::uint64_t used = charged() + datasets;
    return used < most_ ? most_ - used : 0;
}

std::uint64_t Memory::bytes(Held held) const {
    const std::scoped_lock lock(mutex_);
    return bytes_[static_cast<std::size_t>(held)];
}

std::uint64_t Memory::charged() const { return std::accumulate(bytes_.begin(), bytes_.end(), std::uint64_t{0}); }

void Memory::replace(Held held, std::size_t before, std::size_t after) {
    const std::scoped_lock lock(mutex_);
    auto& bytes = bytes_[static_cast<std::size_t>(held)];
    bytes = bytes - before + after;
}

} // namespace server::limits
