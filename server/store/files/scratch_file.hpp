// A file without a name: its place on the disk is reserved when it is made and given back with the process, however
// that ends.
#pragma once

#include "store/files/files.hpp"

namespace ciel::store {

// Not thread-safe.
class ScratchFile {
public:
    // On the disk of `directory`. Throws Error, whose sentence names no path, when nothing can be made there or when
    // the disk does not have `bytes`.
    ScratchFile(const std::filesystem::path& directory, std::uint64_t bytes);

    // REQUIRES: the place lies within the file. Throw Error when the disk fails.
    void write(std::uint64_t offset, std::span<const std::byte> bytes);
    void read(std::uint64_t offset, std::span<std::byte> bytes) const;

private:
    Descriptor file_;
};

} // namespace ciel::store
