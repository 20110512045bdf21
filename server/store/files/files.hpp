// Reads, writes, replaces and locks files. An operation that fails throws FileError, which names the file.
#pragma once

#include "ciel/types.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace server::store {

// what() contains the full path of the file. for_clients() is sent to clients: it contains the path from the dataset's
// directory NAME.ciel on, or only the file name if the file is in no dataset.
class FileError : public ciel::Error {
public:
    FileError(const std::filesystem::path& file, const std::string& sentence);
    [[nodiscard]] const std::string& for_clients() const { return for_clients_; }

private:
    std::string for_clients_;
};

// Returns true if `error` means that memory could not be allocated or that a thread could not be started.
[[nodiscard]] bool is_out_of_memory(const std::exception& error);
// Returns what a server sends to its clients: for_clients() of a FileError, a sentence about memory if
// is_out_of_memory(error), the system's message without the path for an error of the file system, or error.what().
[[nodiscard]] std::string sentence_for_clients(const std::exception& error);

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& sentence); // throws FileError
// Appends to `sentence` that the dataset is damaged and that the user must restore the file or import the data again.
[[noreturn]] void refuse_damage(const std::filesystem::path& file, const std::string& sentence);
// `has`: what happened to the open file: "changed" or "shrunk". Appends how to change files of a dataset.
[[noreturn]] void refuse_open_file(const std::filesystem::path& file, const char* has);
// Appends the system's message for errno to `what_failed`.
[[noreturn]] void refuse_errno(const std::filesystem::path& file, const std::string& what_failed);

// Throws FileError when the file is missing, is not a regular file, or is longer than `limit` bytes.
[[nodiscard]] std::string read_text(const std::filesystem::path& file, std::size_t limit);

// Creates or overwrites a file. Does not flush the file to the disk.
void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
// Writes a temporary file FILE.new-PID, flushes the temporary file to the disk, and renames it to `file`. Readers see
// either the old or the new content. A mapping of the old file stays valid.
void replace_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
// Removes temporary files of killed replace_file calls, also in subdirectories. Files of running calls are locked and
// stay.
void remove_left_beside(const std::filesystem::path& directory);

void make_directory(const std::filesystem::path& directory); // also makes missing parent directories
void sync_directory(const std::filesystem::path& directory);
// Flushes the whole file system, which is faster than flushing each chunk file.
void sync_filesystem(const std::filesystem::path& directory);

[[nodiscard]] inline std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

// Truncates a file to `size` bytes, appends `bytes`, and flushes the file to the disk. If the file has several hard
// links, it is replaced, so that the other links keep the old content.
void append_after(const std::filesystem::path& file, std::uint64_t size, std::span<const std::byte> bytes);

class Descriptor {
public:
    explicit Descriptor(int fd = -1) : fd_(fd) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&& other) noexcept;
    [[nodiscard]] int get() const { return fd_; }

private:
    int fd_;
};

// A new file that is written sequentially. Does not flush the file to the disk. Not thread-safe.
class NewFile {
public:
    explicit NewFile(const std::filesystem::path& file);
    void append(std::span<const std::byte> bytes);
    [[nodiscard]] std::uint64_t size() const { return size_; } // number of bytes written so far

private:
    std::filesystem::path path_;
    Descriptor out_;
    std::uint64_t size_ = 0;
    std::uint64_t sent_ = 0; // number of bytes that the system was told to write to the disk
};

// Thread-safe. Reads the file that was opened, even if the path is later renamed, deleted or given to another file.
class InputFile {
public:
    // Throws FileError when the file is missing, cannot be opened, or is not a regular file.
    explicit InputFile(const std::filesystem::path& file);
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::uint64_t size() const { return size_; } // size in bytes when the file was opened
    // Returns mtime and ctime in nanoseconds. Both change when the content changes and when the file is deleted.
    [[nodiscard]] std::array<std::int64_t, 2> changed_at() const;
    [[nodiscard]] bool is_deleted() const; // true if the file has no path any more, so that no program can open it
    // Throws FileError when the file ends before `to` is full, or when the file cannot be read.
    void read(std::uint64_t offset, std::span<std::byte> to) const;
    // Like read, but stops at the end of the file. Returns the number of bytes that were read.
    std::size_t read_some(std::uint64_t offset, std::span<std::byte> to) const;

private:
    std::filesystem::path path_;
    Descriptor in_;
    std::uint64_t size_ = 0;
};

// Locks until `lock` is destroyed or the process ends. Returns false at once if the directory is locked already.
[[nodiscard]] bool lock_directory(const std::filesystem::path& directory, Descriptor& lock);

} // namespace server::store
