#include "store/cache/mapped_file.hpp"

#include "store/cache/watched_mappings.hpp"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace server::store {

namespace {

void check_status(const std::filesystem::path& file, const struct stat& status, std::size_t bytes) {
    if (!S_ISREG(status.st_mode)) refuse(file, "is not a regular file; restore it or import the data again");
    if (static_cast<std::size_t>(status.st_size) != bytes)
        refuse(file, "has " + std::to_string(status.st_size) + " bytes, but must have " + std::to_string(bytes) +
                         "; restore it or import the data again");
}

[[noreturn]] void refuse_absent(const std::filesystem::path& file) {
    if (errno == ENOENT) refuse(file, "is missing; restore it or import the data again");
    refuse_errno(file, "cannot be opened");
}

[[noreturn]] void refuse_shrunken(const std::filesystem::path& file) { refuse_open_file(file, "shrunk"); }

[[noreturn]] void refuse_changed(const std::filesystem::path& file) { refuse_open_file(file, "changed"); }

FileVersion version_of(const struct stat& status) {
    return {status.st_dev,
            status.st_ino,
            {status.st_mtim.tv_sec, status.st_mtim.tv_nsec},
            {status.st_ctim.tv_sec, status.st_ctim.tv_nsec}};
}

} // namespace

MappedFile::MappedFile(std::filesystem::path file, std::size_t bytes, LossCount losses, std::size_t tail,
                       FileAccess access)
    : path_(std::move(file)), losses_(std::move(losses)) {
    if (bytes == 0) return; // Zarr writes no chunk for an empty array
    Descriptor in(::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (in.get() < 0) refuse_absent(path_);
    if (::fstat(in.get(), &opened_) != 0) refuse_errno(path_, "cannot be examined");
    check_status(path_, opened_, bytes);
    seen_ = opened_;
    // Maps zeroed memory for file and tail. With FileAccess::mapped, the file is then mapped over its beginning.
    mapped_ = bytes + tail;
    const bool is_read = access == FileAccess::read;
    const int protection = is_read ? PROT_READ | PROT_WRITE : PROT_READ;
    void* data = ::mmap(nullptr, mapped_, protection, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (data == MAP_FAILED) refuse_errno(path_, "cannot be mapped");
    if (is_read) {
        in_ = std::move(in);
    } else if (::mmap(data, bytes, PROT_READ, MAP_SHARED | MAP_FIXED, in.get(), 0) == MAP_FAILED) {
        const int failed = errno;
        ::munmap(data, mapped_);
        errno = failed;
        refuse_errno(path_, "cannot be mapped");
    }
    data_ = data;
    size_ = bytes;
    watched_ = watch_mapping(data_, size_, *losses_);
}

MappedFile::~MappedFile() {
    if (data_ == nullptr) return;
    unwatch_mapping(watched_);
    ::munmap(data_, mapped_);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : path_(std::move(other.path_)), data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)),
      mapped_(std::exchange(other.mapped_, 0)), in_(std::move(other.in_)), opened_(other.opened_), seen_(other.seen_),
      losses_(std::move(other.losses_)), watched_(std::exchange(other.watched_, nullptr)) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(mapped_, other.mapped_);
    std::swap(in_, other.in_);
    std::swap(opened_, other.opened_);
    std::swap(seen_, other.seen_);
    std::swap(losses_, other.losses_);
    std::swap(watched_, other.watched_);
    return *this;
}

FileVersion MappedFile::version() const { return version_of(opened_); }

void MappedFile::expect_random_reads() const {
    if (size_ != 0) (void)::madvise(data_, size_, MADV_RANDOM);
}

void MappedFile::copy(std::span<const std::byte> part) const {
    const auto offset = static_cast<std::size_t>(part.data() - static_cast<const std::byte*>(data_));
    auto* const to = static_cast<std::byte*>(data_) + offset;
    for (std::size_t filled = 0; filled < part.size();) {
        const ssize_t got = ::pread(in_.get(), to + filled, part.size() - filled, static_cast<off_t>(offset + filled));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) refuse_errno(path_, "cannot be read");
        if (got == 0) {
            note_loss(*watched_, Loss::shrunk);
            refuse_shrunken(path_);
        }
        filled += static_cast<std::size_t>(got);
    }
}

void MappedFile::load(std::span<const std::byte> part) const {
    if (access() == FileAccess::read) return copy(part);
    // MADV_POPULATE_READ. Linux before 5.14 returns EINVAL; memory pages are then read at their first access.
    constexpr int populate_read = 22;
    static const auto memory_page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    const auto address = reinterpret_cast<std::uintptr_t>(part.data());
    const std::uintptr_t before = address % memory_page;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): rounds a pointer down to its memory page
    auto* const begin = reinterpret_cast<void*>(address - before);
    // Requests all memory pages at once. Without reading ahead (expect_random_reads), each access would read one of
    // them.
    (void)::madvise(begin, part.size() + before, MADV_WILLNEED);
    if (::madvise(begin, part.size() + before, populate_read) == 0) return;
    if (errno == EFAULT || errno == EHWPOISON) refuse();
}

void MappedFile::check_size() const {
    check_intact();
    struct stat status {};
    // If there is no file at the path, the file was deleted, and the mapping keeps its content.
    if (size_ == 0 || ::stat(path_.c_str(), &status) != 0) return;
    if (static_cast<std::size_t>(status.st_size) < size_) refuse_shrunken(path_);
}

bool MappedFile::is_lost() const { return watched_ != nullptr && loss_of(*watched_) != Loss::none; }

void MappedFile::check_intact() const {
    if (watched_ == nullptr) return;
    const Loss loss = loss_of(*watched_);
    if (loss == Loss::shrunk) refuse_shrunken(path_);
    if (loss == Loss::changed) refuse_changed(path_);
}

bool MappedFile::is_current() const {
    struct stat status {};
    return size_ == 0 || (::stat(path_.c_str(), &status) == 0 && version_of(status) == version_of(opened_));
}

bool MappedFile::was_touched() {
    struct stat status {};
    if (size_ == 0 || ::stat(path_.c_str(), &status) != 0 || version_of(status) == version_of(seen_)) return false;
    seen_ = status;
    return true;
}

bool MappedFile::has_shrunk() const {
    struct stat status {};
    return ::stat(path_.c_str(), &status) == 0 && status.st_dev == opened_.st_dev && status.st_ino == opened_.st_ino &&
           static_cast<std::size_t>(status.st_size) < size_;
}

void MappedFile::refuse() const {
    if (watched_ != nullptr) note_loss(*watched_, has_shrunk() ? Loss::shrunk : Loss::changed);
    check_intact(); // throws, unless the file is empty and not watched
    refuse_changed(path_);
}

} // namespace server::store
