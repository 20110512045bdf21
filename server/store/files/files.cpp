#include "store/files/files.hpp"

#include "ciel/types.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <stdexcept>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace server::store {
namespace {

constexpr std::string_view beside_mark = ".new-"; // part of the names of temporary files, which are FILE.new-PID

Descriptor create(const std::filesystem::path& file) {
    Descriptor out(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
    if (out.get() < 0) refuse_errno(file, "cannot be created");
    return out;
}

void write_all(const Descriptor& out, const std::filesystem::path& file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(out.get(), bytes.data(), std::min<std::size_t>(bytes.size(), 1 << 30));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) refuse_errno(file, "cannot be written");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

bool is_beside(const std::string& name) {
    const auto mark = name.rfind(beside_mark);
    if (mark == std::string::npos || mark + beside_mark.size() == name.size()) return false;
    return name.find_first_not_of("0123456789", mark + beside_mark.size()) == std::string::npos;
}

} // namespace

FileError::FileError(const std::filesystem::path& file, const std::string& sentence)
    : ciel::Error(file.string() + ": " + sentence) {
    std::filesystem::path shown;
    for (const std::filesystem::path& part : file) {
        if (shown.empty() && part.extension() != ".ciel") continue;
        shown /= part;
    }
    for_clients_ = (shown.empty() ? file.filename() : shown).string() + ": " + sentence;
}

bool is_out_of_memory(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
    if (dynamic_cast<const std::length_error*>(&error) != nullptr) return true;
    if (const auto* failed = dynamic_cast<const std::system_error*>(&error))
        return failed->code() == std::errc::not_enough_memory ||
               failed->code() == std::errc::resource_unavailable_try_again;
    if (dynamic_cast<const ciel::Error*>(&error) != nullptr) return false;
    // TBB throws an exception when it cannot start a thread. Only the message distinguishes it from other exceptions.
    return std::string_view(error.what()).find(std::strerror(EAGAIN)) != std::string_view::npos;
}

std::string sentence_for_clients(const std::exception& error) {
    if (const auto* of_file = dynamic_cast<const FileError*>(&error)) return of_file->for_clients();
    if (is_out_of_memory(error))
        return "the server does not have enough memory for the request; ask for less at a time, or try again when "
               "other clients have left";
    if (const auto* of_system = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
        return "a file of the server cannot be used: " + of_system->code().message();
    return error.what();
}

void refuse(const std::filesystem::path& file, const std::string& sentence) { throw FileError(file, sentence); }

void refuse_damage(const std::filesystem::path& file, const std::string& sentence) {
    refuse(file, sentence + "; the dataset is damaged: restore the file or import the data again");
}

void refuse_open_file(const std::filesystem::path& file, const char* has) {
    refuse(file,
           std::string("has ") + has +
               " while it was open; restore it or import the data again. To change a file of a dataset, write a new "
               "file and rename it to the old name");
}

void refuse_errno(const std::filesystem::path& file, const std::string& what_failed) {
    const int number = errno;
    refuse(file, what_failed + " (" + std::strerror(number) + ")");
}

namespace {
struct stat status_of(const Descriptor& file, const std::filesystem::path& path) {
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) refuse_errno(path, "cannot be examined");
    return status;
}
} // namespace

InputFile::InputFile(const std::filesystem::path& file)
    // O_NONBLOCK: if the file was replaced by a FIFO, opening it must not block.
    : path_(file), in_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    if (in_.get() < 0) {
        if (errno == ENOENT) refuse(file, "is missing; check the path or restore the file");
        refuse_errno(file, "cannot be opened");
    }
    const struct stat status = status_of(in_, file);
    if (!S_ISREG(status.st_mode)) refuse(file, "is not a regular file; check the path or restore the file");
    size_ = static_cast<std::uint64_t>(status.st_size);
}

bool InputFile::is_deleted() const { return status_of(in_, path_).st_nlink == 0; }

std::array<std::int64_t, 2> InputFile::changed_at() const {
    const struct stat status = status_of(in_, path_);
    const auto nanoseconds = [](const timespec& time) {
        return std::int64_t{time.tv_sec} * 1'000'000'000 + std::int64_t{time.tv_nsec};
    };
    return {nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)};
}

std::size_t InputFile::read_some(std::uint64_t offset, std::span<std::byte> to) const {
    std::size_t filled = 0;
    while (filled < to.size()) {
        const ssize_t got =
            ::pread(in_.get(), to.data() + filled, to.size() - filled, static_cast<off_t>(offset + filled));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) refuse_errno(path_, "cannot be read");
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
    }
    return filled;
}

void InputFile::read(std::uint64_t offset, std::span<std::byte> to) const {
    if (read_some(offset, to) < to.size()) refuse_open_file(path_, "shrunk");
}

std::string read_text(const std::filesystem::path& file, std::size_t limit) {
    const InputFile in(file);
    if (in.size() > limit)
        refuse(file, "is longer than " + std::to_string(limit) +
                         " bytes, the limit for this kind of file; restore the file or use a smaller file");
    std::string text(in.size(), '\0');
    text.resize(in.read_some(0, std::as_writable_bytes(std::span(text))));
    return text;
}

void write_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
    write_all(create(file), file, bytes);
}

void append_after(const std::filesystem::path& file, std::uint64_t size, std::span<const std::byte> bytes) {
    const Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    if (out.get() < 0) refuse_errno(file, "cannot be opened for writing");
    struct stat status {};
    if (::fstat(out.get(), &status) != 0) refuse_errno(file, "cannot be read");
    if (static_cast<std::uint64_t>(status.st_size) < size)
        refuse_damage(file, "has " + std::to_string(status.st_size) + " bytes, but must have at least " +
                                std::to_string(size));
    // Another hard link to the file, such as a backup, must keep the old content.
    if (status.st_nlink > 1) {
        std::vector<std::byte> all(size);
        InputFile(file).read(0, all);
        all.insert(all.end(), bytes.begin(), bytes.end());
        return replace_file(file, all);
    }
    const auto end = static_cast<off_t>(size);
    if (::ftruncate(out.get(), end) != 0 || ::lseek(out.get(), end, SEEK_SET) != end)
        refuse_errno(file, "cannot be written");
    write_all(out, file, bytes);
    if (::fsync(out.get()) != 0) refuse_errno(file, "cannot be flushed to the disk");
}

NewFile::NewFile(const std::filesystem::path& file) : path_(file), out_(create(file)) {}

// Written memory pages that are not on the disk yet count toward the memory limit of the control group. Therefore at
// most two stretches of each file wait for the disk. The later flush (sync_filesystem) reports errors.
void NewFile::append(std::span<const std::byte> bytes) {
    constexpr std::uint64_t stretch = 32 << 20;
    write_all(out_, path_, bytes);
    size_ += bytes.size();
    if (size_ - sent_ < stretch) return;
    const std::uint64_t begin = sent_ < stretch ? 0 : sent_ - stretch;
    ::sync_file_range(out_.get(), static_cast<off64_t>(begin), static_cast<off64_t>(size_ - begin),
                      SYNC_FILE_RANGE_WAIT_BEFORE | SYNC_FILE_RANGE_WRITE);
    sent_ = size_;
}

namespace {

// Returns whether the path leads to the open file.
bool is_named(const Descriptor& open, const std::filesystem::path& path) {
    struct stat of_file {};
    struct stat of_path {};
    return ::fstat(open.get(), &of_file) == 0 && ::lstat(path.c_str(), &of_path) == 0 &&
           of_file.st_ino == of_path.st_ino && of_file.st_dev == of_path.st_dev;
}

// Waits for the lock. Without an effect on file systems without locks.
void lock_file(const Descriptor& file) {
    int result = 0;
    do result = ::flock(file.get(), LOCK_EX);
    while (result != 0 && errno == EINTR);
}

// Creates a file that remove_left_beside does not remove while it is open. A process id could not tell that its writer
// runs: each container has its own ids.
Descriptor create_locked(const std::filesystem::path& file) {
    // Some file systems give a file another number at each look, so that no attempt would succeed.
    constexpr int most_attempts = 100;
    for (int attempt = 1;; ++attempt) {
        Descriptor out(::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644));
        if (out.get() < 0) refuse_errno(file, "cannot be created");
        lock_file(out);
        // Before the lock, remove_left_beside may have removed the file, or another writer of this name renamed it.
        if (!is_named(out, file) && attempt < most_attempts) continue;
        if (::ftruncate(out.get(), 0) != 0) refuse_errno(file, "cannot be written");
        return out;
    }
}

} // namespace

void replace_file(const std::filesystem::path& file, std::span<const std::byte> bytes) {
    std::error_code error;
    if (const auto folder = file.parent_path(); !std::filesystem::is_directory(folder, error))
        refuse(file, "cannot be written: there is no folder " + folder.string() + "; make the folder first");
    const std::filesystem::path beside = file.string() + std::string(beside_mark) + std::to_string(::getpid());
    try {
        const Descriptor out = create_locked(beside);
        write_all(out, beside, bytes);
        if (::fsync(out.get()) != 0) refuse_errno(beside, "cannot be flushed to the disk");
        if (::rename(beside.c_str(), file.c_str()) != 0) refuse_errno(file, "cannot be replaced");
    } catch (...) {
        ::unlink(beside.c_str());
        throw;
    }
    sync_directory(file.parent_path());
}

void remove_left_beside(const std::filesystem::path& directory) {
    std::error_code error;
    for (auto entry = std::filesystem::recursive_directory_iterator(directory, error);
         !error && entry != std::filesystem::recursive_directory_iterator(); entry.increment(error)) {
        const std::filesystem::path& file = entry->path();
        if (!is_beside(file.filename().string())) continue;
        const Descriptor left(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW));
        if (left.get() < 0 || ::flock(left.get(), LOCK_EX | LOCK_NB) != 0) continue;
        // Its writer may have renamed the file before it was locked, and another writer may use the name again.
        if (is_named(left, file)) ::unlink(file.c_str());
    }
}

void make_directory(const std::filesystem::path& directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) refuse(directory, "cannot be created (" + error.message() + ")");
}

void sync_directory(const std::filesystem::path& directory) {
    const Descriptor fd(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (fd.get() < 0 || ::fsync(fd.get()) != 0) refuse_errno(directory, "cannot be flushed to the disk");
}

void sync_filesystem(const std::filesystem::path& directory) {
    const Descriptor fd(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (fd.get() < 0 || ::syncfs(fd.get()) != 0) refuse_errno(directory, "cannot be flushed to the disk");
}

Descriptor::~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
}

Descriptor::Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
}

bool lock_directory(const std::filesystem::path& directory, Descriptor& lock) {
    Descriptor fd(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (fd.get() < 0) refuse_errno(directory, "cannot be opened");
    if (::flock(fd.get(), LOCK_EX | LOCK_NB) != 0) return false;
    lock = std::move(fd);
    return true;
}

} // namespace server::store
