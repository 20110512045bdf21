#include "store/cache/watched_mappings.hpp"

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <mutex>
#include <sys/mman.h>
#include <unistd.h>

namespace server::store {

// Nodes are never deleted, so that the signal handler can read the list at any time. begin == 0: the node is free.
struct WatchedMapping {
    std::atomic<std::uintptr_t> begin{0};
    std::atomic<std::size_t> bytes{0};
    std::atomic<Loss> loss{Loss::none};
    std::atomic<std::size_t> lost_pages{0}; // memory pages that were replaced by zeros
    std::atomic<std::atomic<std::uint32_t>*> losses{nullptr};
    WatchedMapping* next = nullptr;
};

namespace {

std::atomic<WatchedMapping*> first{nullptr};
std::atomic<std::size_t> lost_count{0};
std::mutex changing;
struct sigaction previous {};
// Lost memory pages apart from each other are mappings of their own, of which a process may have 65,530. After this
// number, the whole file is replaced by zeros.
constexpr std::size_t most_lost_pages = 64;
const auto memory_page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));

static_assert(std::atomic<std::uintptr_t>::is_always_lock_free && std::atomic<std::uint32_t>::is_always_lock_free &&
              std::atomic<Loss>::is_always_lock_free);

// Reads `begin` twice, because another thread may give the node to another mapping meanwhile.
bool holds(const WatchedMapping& mapping, std::uintptr_t address) {
    const std::uintptr_t begin = mapping.begin.load();
    const std::size_t bytes = mapping.bytes.load();
    return begin != 0 && address >= begin && address - begin < bytes && mapping.begin.load() == begin;
}

bool map_zeros(std::uintptr_t begin, std::size_t bytes) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the address came from a pointer
    return ::mmap(reinterpret_cast<void*>(begin), bytes, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0) !=
           MAP_FAILED;
}

// Runs in a signal handler, and therefore uses only atomics and system calls.
bool replace_by_zeros(std::uintptr_t address) {
    for (WatchedMapping* each = first.load(); each != nullptr; each = each->next) {
        if (!holds(*each, address)) continue;
        note_loss(*each, Loss::shrunk);
        if (++each->lost_pages <= most_lost_pages && map_zeros(address - address % memory_page, memory_page))
            return true;
        return map_zeros(each->begin.load(), each->bytes.load());
    }
    return false;
}

void on_bus_error(int number, siginfo_t* info, void*) {
    const int of_program = errno;
    // The previous handler gets the signal when the access is repeated.
    if (!replace_by_zeros(reinterpret_cast<std::uintptr_t>(info->si_addr))) ::sigaction(number, &previous, nullptr);
    errno = of_program;
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
    auto* node = new WatchedMapping; // never deleted: the signal handler may be reading it
    node->next = first.load();
    first = node;
    return node;
}

} // namespace

WatchedMapping* watch_mapping(void* data, std::size_t bytes, std::atomic<std::uint32_t>& losses) {
    static std::once_flag installed;
    std::call_once(installed, install_handler);
    const std::lock_guard lock(changing);
    WatchedMapping* node = free_node();
    node->loss = Loss::none;
    node->lost_pages = 0;
    node->losses = &losses;
    node->bytes = bytes;
    node->begin = reinterpret_cast<std::uintptr_t>(data);
    return node;
}

void unwatch_mapping(WatchedMapping* mapping) {
    const std::lock_guard lock(changing);
    mapping->begin = 0;
    if (mapping->loss != Loss::none) --lost_count;
}

Loss loss_of(const WatchedMapping& mapping) { return mapping.loss; }

void note_loss(WatchedMapping& mapping, Loss loss) {
    Loss none = Loss::none;
    if (!mapping.loss.compare_exchange_strong(none, loss)) return;
    ++lost_count;
    ++*mapping.losses.load();
}

std::size_t lost_mapping_count() { return lost_count; }

} // namespace server::store
