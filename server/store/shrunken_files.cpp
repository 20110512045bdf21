#include "store/shrunken_files.hpp"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <mutex>
#include <sys/mman.h>

namespace ciel::store {

// A node of a list that only grows, so that the handler can walk it at any moment; a node without data is free for the
// next mapping.
struct WatchedMapping {
    std::atomic<std::uintptr_t> begin{0};
    std::atomic<std::size_t> bytes{0};
    std::atomic<bool> lost{false};
    WatchedMapping* next = nullptr;
};

namespace {

std::atomic<WatchedMapping*> first{nullptr};
std::atomic<bool> any_lost{false};
std::mutex changing;
struct sigaction previous {};

static_assert(std::atomic<std::uintptr_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

// Only what is allowed in a signal handler: atomics and system calls.
bool replace_by_zeros(std::uintptr_t address) {
    for (WatchedMapping* each = first.load(); each != nullptr; each = each->next) {
        const std::uintptr_t begin = each->begin.load();
        const std::size_t bytes = each->bytes.load();
        if (begin == 0 || address < begin || address - begin >= bytes) continue;
        each->lost = true;
        any_lost = true;
        // NOLINTNEXTLINE(performance-no-int-to-ptr): the address came from a pointer
        return ::mmap(reinterpret_cast<void*>(begin), bytes, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1,
                      0) != MAP_FAILED;
    }
    return false;
}

void on_bus_error(int number, siginfo_t* info, void*) {
    // si_addr may be anywhere in the page behind the file's end, which lies in the mapping's last page at most.
    if (replace_by_zeros(reinterpret_cast<std::uintptr_t>(info->si_addr))) return;
    ::sigaction(number, &previous, nullptr); // not ours: the access is repeated, and whoever was there before gets it
}

void install_handler() {
    struct sigaction action {};
    action.sa_sigaction = on_bus_error;
    action.sa_flags = SA_SIGINFO;
    ::sigemptyset(&action.sa_mask);
    ::sigaction(SIGBUS, &action, &previous);
}

WatchedMapping* free_node() {
    for (WatchedMapping* each = first.load(); each != nullptr; each = each->next)
        if (each->begin.load() == 0) return each;
    auto* node = new WatchedMapping; // lives as long as the process: the handler may be looking at it
    node->next = first.load();
    first = node;
    return node;
}

} // namespace

WatchedMapping* watch_mapping(void* data, std::size_t bytes) {
    static std::once_flag installed;
    std::call_once(installed, install_handler);
    const std::lock_guard lock(changing);
    WatchedMapping* node = free_node();
    node->lost = false;
    node->bytes = bytes;
    node->begin = reinterpret_cast<std::uintptr_t>(data);
    return node;
}

void unwatch_mapping(WatchedMapping* mapping) {
    const std::lock_guard lock(changing);
    mapping->begin = 0;
}

bool is_lost(const WatchedMapping& mapping) { return mapping.lost; }

bool any_mapping_lost() { return any_lost; }

} // namespace ciel::store
