// Reads, writes and atomically replaces whole files; makes and locks directories. Failures throw FileError, which names
// the file.
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

namespace ciel::store {

// An Error about a file. what() has the file's whole path, for the user who runs the program. for_clients() has only
// the path from the dataset's directory on, for clients of a server.
class FileError : public Error {
public:
    FileError(const std::filesystem::path& file, const std::string& sentence);
    [[nodiscard]] const std::string& for_clients() const { return for_clients_; }

private:
    std::string for_clients_;
};

// Returns whether `error` was thrown because the system gave no more memory or could not start a thread.
[[nodiscard]] bool is_out_of_memory(const std::exception& error);
// Returns the message for clients of a server: without directories of the machine, and without the C++ library's
// wording when memory ran out.
[[nodiscard]] std::string sentence_for_clients(const std::exception& error);

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& sentence); // throws FileError
// Throws FileError. Adds to the sentence that the dataset is damaged, and what to do.
[[noreturn]] void refuse_damage(const std::filesystem::path& file, const std::string& sentence);
[[noreturn]] void refuse_errno(const std::filesystem::path& file, const std::string& what_failed);

// Returns the content of a file. Throws FileError when it is missing, not a regular file, or longer than `limit` bytes.
[[nodiscard]] std::string read_text(const std::filesystem::path& file, std::size_t limit);

// Writes a new file, without flushing it to the disk.
void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
// Writes FILE.new-PID, flushes it to the disk and renames it to `file`. Readers see the old or the new file, and a
// mapping of the old file stays valid.
void replace_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
// Removes the temporary files of killed calls of replace_file in `directory` and below it. Files of running calls are
// locked and stay.
void remove_left_beside(const std::filesystem::path& directory);

void make_directory(const std::filesystem::path& directory); // and its parents
void sync_directory(const std::filesystem::path& directory);
// Flushes the whole file system that holds `directory`. This is faster than flushing each chunk.
void sync_filesystem(const std::filesystem::path& directory);

[[nodiscard]] inline std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

// Writes bytes after the first `size` bytes of a file, truncates what is behind, and flushes the file to the disk.
// Readers of the first `size` bytes are not disturbed. A file with several hard links is replaced by a new one.
void append_after(const std::filesystem::path& file, std::uint64_t size, std::span<const std::byte> bytes);

// Owns a file descriptor.
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

// A new file that is written from its begin to its end, without flushing it to the disk. Not thread-safe.
class NewFile {
public:
    explicit NewFile(const std::filesystem::path& file);
    void append(std::span<const std::byte> bytes);
    [[nodiscard]] std::uint64_t size() const { return size_; } // in bytes, so far

private:
    std::filesystem::path path_;
    Descriptor out_;
    std::uint64_t size_ = 0;
};

// A file that is read at any place. Thread-safe. It stays open when its path is given to another file.
class InputFile {
public:
    // Throws FileError when the file is missing, cannot be opened, or is not a regular file.
    explicit InputFile(const std::filesystem::path& file);
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::uint64_t size() const { return size_; } // in bytes, when it was opened
    // Returns the times of the last changes of its content and of its status, in nanoseconds. They change whenever the
    // content changes, and when the file is deleted.
    [[nodiscard]] std::array<std::int64_t, 2> changed_at() const;
    [[nodiscard]] bool is_deleted() const; // no path leads to it any more, so no other program can change it
    // Fills `to` with the bytes from `offset` on. Throws FileError when the file has fewer bytes or cannot be read.
    void read(std::uint64_t offset, std::span<std::byte> to) const;
    // Like read, but stops at the end of the file. Returns the number of bytes.
    std::size_t read_some(std::uint64_t offset, std::span<std::byte> to) const;

private:
    std::filesystem::path path_;
    Descriptor in_;
    std::uint64_t size_ = 0;
};

// Locks a directory until `lock` is destroyed or the process ends. Returns false when the directory is locked already.
[[nodiscard]] bool lock_directory(const std::filesystem::path& directory, Descriptor& lock);

} // namespace ciel::store
