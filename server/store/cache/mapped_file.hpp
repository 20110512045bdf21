// MappedFile: a file of a known size, mapped for reading. Programs must replace the files of a dataset (new file +
// rename), and never truncate or rewrite them in place. A mapping of a replaced or deleted file stays valid. In a
// mapping of a truncated file, the memory pages that cannot be read have zeros. A mapping of a rewritten file shows the
// new content. Both mappings are called lost: check_intact throws as soon as the change has been detected
// (watched_mappings.hpp).
#pragma once

#include "store/files/files.hpp"
#include "store/files/local_files.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <sys/stat.h>

namespace server::store {

struct WatchedMapping; // watched_mappings.hpp

// Identifies a file and its content. The FileVersion at a path changes when the file is replaced or written to.
struct FileVersion {
    std::uint64_t device = 0, inode = 0;
    std::array<std::int64_t, 2> modified{}, status_changed{}; // [seconds, nanoseconds]
    [[nodiscard]] bool operator==(const FileVersion&) const = default;
};

// Number of mappings that a dataset has lost so far. While the number stays the same, callers need not check each file.
using LossCount = std::shared_ptr<std::atomic<std::uint32_t>>;
[[nodiscard]] inline LossCount no_losses() { return std::make_shared<std::atomic<std::uint32_t>>(0); }

// Thread-safe, except for moves and was_touched.
class MappedFile {
public:
    MappedFile() = default;
    // Throws Error when `file` is missing, is not a regular file, or does not have `bytes` bytes. If `bytes` is 0,
    // opens no file. `tail`: number of zero bytes that can be read after the end of the file. FileAccess::read: the
    // memory has zeros until `load` copies bytes of the file.
    MappedFile(std::filesystem::path file, std::size_t bytes, LossCount losses = no_losses(), std::size_t tail = 0,
               FileAccess access = FileAccess::mapped);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::span<const std::byte> bytes() const { return {static_cast<const std::byte*>(data_), size_}; }
    template <typename T>
    [[nodiscard]] std::span<const T> as() const {
        return {static_cast<const T*>(data_), size_ / sizeof(T)};
    }

    [[nodiscard]] FileVersion version() const; // version of the file when it was opened
    // Advises the system not to read ahead.
    void expect_random_reads() const;
    // Reads `part`, a range of bytes(), from the disk with one request. Without this call, the first access to each
    // memory page reads only that page. Throws Error when `part` cannot be read. The mapping is then lost, except after
    // a read error with FileAccess::read. With FileAccess::read, two threads must not load or use the same part at the
    // same time.
    void load(std::span<const std::byte> part) const;
    [[nodiscard]] FileAccess access() const { return in_.get() < 0 ? FileAccess::mapped : FileAccess::read; }

    // Throws Error when the mapping is lost, or when the file at the path is shorter than the mapping.
    void check_size() const;
    [[nodiscard]] bool is_lost() const;
    // Throws Error when the mapping is lost. The caller must then discard all data that it has read from the mapping.
    void check_intact() const;
    [[nodiscard]] bool is_current() const;
    // Returns true if the file was written to or replaced since the last call, or since it was opened. The caller must
    // then check the content again: the file may have been replaced because it was damaged.
    [[nodiscard]] bool was_touched();
    // Marks the mapping as lost, because the file has changed or shrunk. Throws Error that says which.
    [[noreturn]] void refuse() const;

private:
    void copy(std::span<const std::byte> part) const;
    [[nodiscard]] bool has_shrunk() const; // whether the file that was opened is now shorter than the mapping

    std::filesystem::path path_;
    void* data_ = nullptr;
    std::size_t size_ = 0, mapped_ = 0; // mapped_: size with the tail, in bytes
    Descriptor in_;                     // the open file, with FileAccess::read only
    struct stat opened_ {};             // status of the file when it was opened
    struct stat seen_ {};               // status of the file at the last call of was_touched
    LossCount losses_;
    WatchedMapping* watched_ = nullptr;
};

} // namespace server::store
