#include "store/files/scratch_file.hpp"

#include "ciel/types.hpp"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace server::store {
namespace {

[[noreturn]] void fail_errno(const std::string& sentence, int number) {
    throw ciel::Error(sentence + " (" + std::strerror(number) + ")");
}

// For file systems without O_TMPFILE: creates a file with a name and unlinks it at once.
Descriptor make_named(const std::filesystem::path& directory) {
    static std::atomic<std::uint64_t> last{0}; // makes the name unique, because two threads must not open the same file
    const std::string name =
        (directory / (".upload-" + std::to_string(++last) + ".new-" + std::to_string(::getpid()))).string();
    Descriptor file(::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    if (file.get() >= 0) ::unlink(name.c_str());
    return file;
}

Descriptor make(const std::filesystem::path& directory) {
    Descriptor file(::open(directory.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600));
    if (file.get() < 0 && (errno == EOPNOTSUPP || errno == EISDIR || errno == EINVAL)) file = make_named(directory);
    if (file.get() < 0)
        fail_errno("no temporary file can be made in the dataset's directory; allow the server to write there", errno);
    return file;
}

} // namespace

ScratchFile::ScratchFile(const std::filesystem::path& directory, std::uint64_t bytes) : file_(make(directory)) {
    if (bytes == 0) return;
    if (const int error = ::posix_fallocate(file_.get(), 0, static_cast<off_t>(bytes)); error != 0)
        fail_errno("the dataset's disk has no room for " + std::to_string(bytes) + " bytes; free some space", error);
}

void ScratchFile::write(std::uint64_t offset, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(file_.get(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail_errno("the dataset's disk cannot be written; check the disk and try again", errno);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        offset += static_cast<std::uint64_t>(written);
    }
}

void ScratchFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
    while (!bytes.empty()) {
        const ssize_t got = ::pread(file_.get(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0)
            fail_errno("the dataset's disk cannot be read; check the disk and try again", got == 0 ? EIO : errno);
        bytes = bytes.subspan(static_cast<std::size_t>(got));
        offset += static_cast<std::uint64_t>(got);
    }
}

} // namespace server::store
