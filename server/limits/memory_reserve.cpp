#include "limits/memory_reserve.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace server::limits {
namespace {

constexpr std::size_t reserve_bytes = std::size_t{4} << 20;

std::atomic<void*> reserve{nullptr};

void give_reserve_away() {
    void* kept = reserve.exchange(nullptr);
    if (kept == nullptr) throw std::bad_alloc();
    std::free(kept);
}

} // namespace

void keep_memory_in_reserve() {
    std::set_new_handler(give_reserve_away);
    if (reserve.load() != nullptr) return;
    void* kept = std::malloc(reserve_bytes); // never written, so that it takes address space but no memory
    void* none = nullptr;
    if (kept != nullptr && !reserve.compare_exchange_strong(none, kept)) std::free(kept);
}

} // namespace server::limits
