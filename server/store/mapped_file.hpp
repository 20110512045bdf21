// A file mapped for reading, of exactly the expected size.
//
// Whoever changes a dataset replaces files (new file + rename) and never truncates or rewrites them in place; a mapping
// of a replaced or deleted file stays valid. A file that shrinks all the same reads as zeros from then on, and
// check_intact says so (shrunken_files.hpp).
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace ciel::store {

struct WatchedMapping; // shrunken_files.hpp

// Throws Error when `file` is missing, not a regular file, or of another size.
void check_file_size(const std::filesystem::path& file, std::size_t bytes);

class MappedFile {
public:
    MappedFile() = default;
    // Throws Error when it is missing, not a regular file, or of another size. Zero bytes: nothing is opened.
    MappedFile(std::filesystem::path file, std::size_t bytes);
    ~MappedFile();
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
    // Throws Error when the file has shrunk under a reader: what was read since is worthless.
    void check_intact() const;

private:
    std::filesystem::path path_;
    void* data_ = nullptr;
    std::size_t size_ = 0;
    WatchedMapping* watched_ = nullptr;
};

} // namespace ciel::store
