// A library for LD_PRELOAD: refuses blocks of memory of more than CIEL_MOST_BLOCK bytes as if memory had run out, and
// says so on the standard error. Memory that a program maps itself is not refused.
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <unistd.h>

// The allocator of glibc.
extern "C" void* __libc_malloc(std::size_t);
extern "C" void* __libc_calloc(std::size_t, std::size_t);
extern "C" void* __libc_realloc(void*, std::size_t);
extern "C" void* __libc_memalign(std::size_t, std::size_t);

namespace {

std::size_t most_bytes() {
    static const std::size_t most = [] {
        const char* const text = ::getenv("CIEL_MOST_BLOCK");
        return text != nullptr ? std::strtoull(text, nullptr, 10) : std::numeric_limits<std::size_t>::max();
    }();
    return most;
}

bool is_refused(std::size_t bytes) {
    if (bytes <= most_bytes()) return false;
    std::array<char, 64> line{};
    const int length = std::snprintf(line.data(), line.size(), "refused a block of %zu bytes\n", bytes);
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), static_cast<std::size_t>(length));
    errno = ENOMEM;
    return true;
}

} // namespace

extern "C" void* malloc(std::size_t bytes) { return is_refused(bytes) ? nullptr : __libc_malloc(bytes); }
extern "C" void* calloc(std::size_t count, std::size_t bytes) {
    return bytes > 0 && is_refused(count * bytes) ? nullptr : __libc_calloc(count, bytes);
}
extern "C" void* realloc(void* block, std::size_t bytes) {
    return is_refused(bytes) ? nullptr : __libc_realloc(block, bytes);
}
extern "C" void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
    return is_refused(bytes) ? nullptr : __libc_memalign(alignment, bytes);
}
extern "C" int posix_memalign(void** block, std::size_t alignment, std::size_t bytes) {
    void* const made = aligned_alloc(alignment, bytes);
    if (made != nullptr) *block = made;
    return made != nullptr ? 0 : ENOMEM;
}
