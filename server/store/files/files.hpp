// Files as the store needs them: read whole, written whole, replaced atomically. Every failure is an Error that names
// the file.
#pragma once

#include "ciel/types.hpp"

#include <cstddef>
#include <exception>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace ciel::store {

// An Error about a file. Who runs the program is told where the file lies; clients of a server are told only where in
// which dataset.
class FileError : public Error {
public:
    FileError(const std::filesystem::path& file, const std::string& sentence);
    [[nodiscard]] const std::string& for_clients() const { return for_clients_; }

private:
    std::string for_clients_;
};

// Whether it is what the libraries make of memory, or of a thread, that the system does not give.
[[nodiscard]] bool is_out_of_memory(const std::exception& error);
// What a client of a server may be told of an error: no folders of the machine, no names of the C++ library.
[[nodiscard]] std::string sentence_for_clients(const std::exception& error);

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& sentence); // throws FileError
[[noreturn]] void refuse_errno(const std::filesystem::path& file, const std::string& what_failed);

// Throws when it is missing, not a regular file, or longer than `limit`.
[[nodiscard]] std::string read_text(const std::filesystem::path& file, std::size_t limit);

// A new file; not flushed to the disk.
void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
// Written beside as FILE.new-PID, flushed and renamed over `file`: readers see the old or the new one, and a mapping of
// the old one stays valid.
void replace_file(const std::filesystem::path& file, std::span<const std::byte> bytes);
// Removes what killed calls of replace_file have left in `directory` and below it. The files of living ones are locked
// and stay.
void remove_left_beside(const std::filesystem::path& directory);

void make_directory(const std::filesystem::path& directory); // and its parents
void sync_directory(const std::filesystem::path& directory);
// One flush for everything on the file system that holds `directory`: cheaper than one per chunk.
void sync_filesystem(const std::filesystem::path& directory);

[[nodiscard]] inline std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

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

// A lock that ends with the process. Returns false when another process holds it.
[[nodiscard]] bool lock_directory(const std::filesystem::path& directory, Descriptor& lock);

} // namespace ciel::store
