// A file mapped for reading, of exactly the expected size.
//
// Whoever changes a dataset replaces files (new file + rename) and never truncates or rewrites them in place; a mapping
// of a replaced or deleted file stays valid. A file that shrinks all the same reads as zeros from then on; one that is
// rewritten reads as whatever is written. check_intact says so once either was noticed (watched_mappings.hpp).
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <sys/stat.h>

namespace ciel::store {

struct WatchedMapping; // watched_mappings.hpp

// Whether any of a dataset's mapped files was lost: as long as none was, nobody needs to ask for each.
using AnyLost = std::shared_ptr<std::atomic<bool>>;
[[nodiscard]] inline AnyLost none_lost() { return std::make_shared<std::atomic<bool>>(false); }

// Throws Error when `file` is missing, not a regular file, or of another size.
void check_file_size(const std::filesystem::path& file, std::size_t bytes);

// Thread-safe but for moving.
class MappedFile {
public:
    MappedFile() = default;
    // Throws Error when it is missing, not a regular file, or of another size. Zero bytes: nothing is opened.
    MappedFile(std::filesystem::path file, std::size_t bytes, AnyLost any_lost = none_lost());
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

    // Throws Error when the file has shrunk under a reader, or at the path is a shorter one.
    void check_size() const;
    // Throws Error when it was lost: what was read since is worthless.
    void check_intact() const;
    // Whether somebody may have written to the mapped file since it was opened or since accept_touch: its inode
    // changed.
    [[nodiscard]] bool was_touched() const;
    void accept_touch(); // it holds what it held. Not together with was_touched
    // Throws Error: it holds what it did not hold when it was opened. It is lost from now on.
    [[noreturn]] void refuse() const;

private:
    std::filesystem::path path_;
    void* data_ = nullptr;
    std::size_t size_ = 0;
    struct stat opened_ {}; // the inode, as it was when its content was last known
    AnyLost any_lost_;
    WatchedMapping* watched_ = nullptr;
};

} // namespace ciel::store
