#include "fields/sparse_array.hpp"

#include <cstdlib>
#include <cstring>
#include <new>
#ifndef __wasm__
#include <sys/mman.h>
#endif

namespace ciel::detail {

#ifdef __wasm__ // WebAssembly has no mmap and no exceptions

void* reserve_zeroed(std::size_t bytes) { return std::memset(::operator new(bytes), 0, bytes); }
void release_zeroed(void* begin, std::size_t) { ::operator delete(begin); }

#else

namespace {

// In bytes. Smaller arrays come from the heap, because reused memory costs less than new memory.
constexpr std::size_t large = std::size_t{16} << 20;

} // namespace

void* reserve_zeroed(std::size_t bytes) {
    if (bytes < large) {
        void* const begin = std::calloc(bytes > 0 ? bytes : 1, 1);
        if (begin == nullptr) throw std::bad_alloc();
        return begin;
    }
    void* const begin =
        ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (begin == MAP_FAILED) throw std::bad_alloc();
    return begin;
}

void release_zeroed(void* begin, std::size_t bytes) {
    if (bytes < large)
        std::free(begin);
    else
        ::munmap(begin, bytes);
}

#endif

} // namespace ciel::detail
