// MappedFile: a file of a known size, mapped for reading.
//
// Programs that change a dataset must replace its files (new file + rename), and never truncate or rewrite them in
// place. A mapping of a replaced or deleted file stays valid. If a mapped file shrinks all the same, its mapping reads
// as zeros from then on. If it is rewritten, the mapping shows the new content. In both cases the mapping is lost:
// check_intact throws as soon as the change has been noticed (watched_mappings.hpp).
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

namespace ciel::store {

struct WatchedMapping; // watched_mappings.hpp

// Identifies a file and its content: it changes when the file at a path is replaced or written to.
struct FileVersion {
    std::uint64_t device = 0, inode = 0;
    std::array<std::int64_t, 2> modified{}, status_changed{}; // seconds, nanoseconds
    [[nodiscard]] bool operator==(const FileVersion&) const = default;
};

// Shared by the mapped files of a dataset. True once one of them is lost; until then no single file needs a check.
using AnyLost = std::shared_ptr<std::atomic<bool>>;
[[nodiscard]] inline AnyLost none_lost() { return std::make_shared<std::atomic<bool>>(false); }

// Thread-safe, except moving and was_touched.
class MappedFile {
public:
    MappedFile() = default;
    // Throws Error when `file` is missing, not a regular file, or not `bytes` long. If `bytes` is 0, opens no file.
    // `tail`: number of bytes behind the file that can be read, too; they are 0. FileAccess::read: there are zeros in
    // place of the file, until `load` copies parts of it.
    MappedFile(std::filesystem::path file, std::size_t bytes, AnyLost any_lost = none_lost(), std::size_t tail = 0,
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

    [[nodiscard]] FileVersion version() const; // of the file when it was opened
    // Tells the system to expect reads at random places, so that it does not read ahead.
    void expect_random_reads() const;
    // Reads a part from the disk at once, not page by page when it is touched. Throws Error when it cannot be read: the
    // mapping is lost then. With FileAccess::read, the same part must not be loaded or used on two threads at once.
    void load(std::span<const std::byte> part) const;
    [[nodiscard]] FileAccess access() const { return in_.get() < 0 ? FileAccess::mapped : FileAccess::read; }

    // Throws Error when the mapping is lost, or when the file at the path is shorter than the mapping.
    void check_size() const;
    [[nodiscard]] bool is_lost() const;
    // Throws Error when the mapping is lost. Then everything that was read from it must be discarded.
    void check_intact() const;
    // Returns whether the file at the path is the mapped one, unchanged since it was opened.
    [[nodiscard]] bool is_current() const;
    // Returns whether the file at the path was written to or replaced since it was opened or since the last call. Then
    // the content of the mapping has to be checked again: a file that was replaced can have been damaged when it was
    // mapped.
    [[nodiscard]] bool was_touched();
    // Marks the mapping as lost, because its content has changed, and throws Error.
    [[noreturn]] void refuse() const;

private:
    void copy(std::span<const std::byte> part) const;

    std::filesystem::path path_;
    void* data_ = nullptr;
    std::size_t size_ = 0, mapped_ = 0; // mapped_: with the tail
    Descriptor in_;                     // the open file, with FileAccess::read only
    struct stat opened_ {};             // status of the file when it was opened
    struct stat seen_ {};               // at the last was_touched
    AnyLost any_lost_;
    WatchedMapping* watched_ = nullptr;
};

} // namespace ciel::store
