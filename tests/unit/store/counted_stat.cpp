#include "unit/store/counted_stat.hpp"

#include <atomic>
#include <fcntl.h>
#include <sys/stat.h>

namespace {
std::atomic<std::size_t> calls{0};
}

namespace ciel::test {
std::size_t stat_calls() { return calls; }
} // namespace ciel::test

// These functions replace those of the C library for the store and for the C++ library.
extern "C" {
int stat(const char* path, struct stat* status) noexcept {
    ++calls;
    return ::fstatat(AT_FDCWD, path, status, 0);
}
int lstat(const char* path, struct stat* status) noexcept {
    ++calls;
    return ::fstatat(AT_FDCWD, path, status, AT_SYMLINK_NOFOLLOW);
}
int fstat(int file, struct stat* status) noexcept {
    ++calls;
    return ::fstatat(file, "", status, AT_EMPTY_PATH);
}
}
