#include "store/mapped_file.hpp"

#include "store/files.hpp"
#include "store/shrunken_files.hpp"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace ciel::store {

namespace {

void check_status(const std::filesystem::path& file, const struct stat& status, std::size_t bytes) {
    if (!S_ISREG(status.st_mode)) refuse(file, "is not a regular file");
    if (static_cast<std::size_t>(status.st_size) != bytes)
        refuse(file, "has " + std::to_string(status.st_size) + " bytes where " + std::to_string(bytes) +
                         " are declared; restore it or import the data again");
}

[[noreturn]] void refuse_absent(const std::filesystem::path& file) {
    if (errno == ENOENT) refuse(file, "is missing; restore it or import the data again");
    refuse_errno(file, "cannot be opened");
}

[[noreturn]] void refuse_shrunken(const std::filesystem::path& file) {
    refuse(file, "has shrunk while it was open; restore it, and replace files of a dataset instead of truncating them");
}

} // namespace

void check_file_size(const std::filesystem::path& file, std::size_t bytes) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) refuse_absent(file);
    check_status(file, status, bytes);
}

MappedFile::MappedFile(std::filesystem::path file, std::size_t bytes) : path_(std::move(file)) {
    if (bytes == 0) return; // Zarr writes no chunk for an empty array
    const Descriptor in(::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (in.get() < 0) refuse_absent(path_);
    struct stat status {};
    if (::fstat(in.get(), &status) != 0) refuse_errno(path_, "cannot be examined");
    check_status(path_, status, bytes);
    void* data = ::mmap(nullptr, bytes, PROT_READ, MAP_SHARED, in.get(), 0);
    if (data == MAP_FAILED) refuse_errno(path_, "cannot be mapped");
    data_ = data;
    size_ = bytes;
    watched_ = watch_mapping(data_, size_);
}

MappedFile::~MappedFile() {
    if (data_ == nullptr) return;
    unwatch_mapping(watched_);
    ::munmap(data_, size_);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : path_(std::move(other.path_)), data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)),
      watched_(std::exchange(other.watched_, nullptr)) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(watched_, other.watched_);
    return *this;
}

void MappedFile::check_size() const {
    check_intact();
    struct stat status {};
    // A missing file was replaced or deleted: the mapping keeps its content.
    if (size_ == 0 || ::stat(path_.c_str(), &status) != 0) return;
    if (static_cast<std::size_t>(status.st_size) < size_) refuse_shrunken(path_);
}

void MappedFile::check_intact() const {
    if (watched_ != nullptr && is_lost(*watched_)) refuse_shrunken(path_);
}

} // namespace ciel::store
