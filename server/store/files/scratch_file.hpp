// ScratchFile: a temporary file without a name. Its disk space is reserved by the constructor. The space is freed when
// the object is destroyed or the process ends, even when the process is killed.
#pragma once

#include "store/files/files.hpp"

namespace server::store {

// Not thread-safe.
class ScratchFile {
public:
    // Makes a file of `bytes` bytes on the disk of `directory`. Throws Error when no file can be made there, or when
    // the disk does not have enough free space. The message contains no path, because a server sends it to its clients.
    ScratchFile(const std::filesystem::path& directory, std::uint64_t bytes);

    // REQUIRES: [offset, offset + bytes.size()) lies within the file. Both functions throw Error when the disk fails.
    void write(std::uint64_t offset, std::span<const std::byte> bytes);
    void read(std::uint64_t offset, std::span<std::byte> bytes) const;
    [[nodiscard]] int descriptor() const { return file_.get(); } // a mapping of it may outlive the object

private:
    Descriptor file_;
};

} // namespace server::store
