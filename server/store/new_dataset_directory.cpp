#include "store/new_dataset_directory.hpp"

#include "store/format/layout.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace server::store {
namespace {

namespace fs = std::filesystem;

std::string temporary_prefix(const fs::path& target) {
    return std::string(".") + target.filename().string() + ".writing-";
}

} // namespace

void remove_left_behind(const fs::path& given) {
    const fs::path target = fs::absolute(given).lexically_normal();
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(target.parent_path(), error)) {
        if (!entry.path().filename().string().starts_with(temporary_prefix(target)) || !entry.is_directory(error))
            continue;
        Descriptor lock;
        if (lock_directory(entry.path(), lock)) fs::remove_all(entry.path(), error);
    }
}

NewDatasetDirectory::NewDatasetDirectory(const fs::path& target, bool overwrite)
    : target_(fs::absolute(target).lexically_normal()), overwrite_(overwrite) {
    if (!target_.has_filename()) target_ = target_.parent_path();
    check_target();
    remove_left_behind(target_);
    make_temporary();
    if (lock_directory(temporary_, lock_)) return;
    std::error_code error;
    fs::remove(temporary_, error);
    refuse(temporary_, "cannot be locked: its file system has no locks, or another process uses it; write to another "
                       "file system, or wait until the process ends");
}

void check_new_dataset_directory(const fs::path& target, bool overwrite) {
    const NewDatasetDirectory directory(target, overwrite);
}

void NewDatasetDirectory::make_temporary() {
    const fs::path folder = target_.parent_path();
    std::error_code error;
    if (!fs::is_directory(folder, error))
        refuse(target_, "cannot be written: there is no folder " + folder.string() + "; make the folder first");
    const std::string name = temporary_prefix(target_) + std::to_string(::getpid());
    temporary_ = folder / name;
    // The name already exists if this process has another writer of the same target.
    for (int attempt = 1; !fs::create_directory(temporary_, error); ++attempt) {
        if (error)
            refuse(target_,
                   "cannot be written: no file can be made in " + folder.string() + " (" + error.message() + ")");
        temporary_ = folder / (name + "-" + std::to_string(attempt));
    }
}

NewDatasetDirectory::~NewDatasetDirectory() {
    std::error_code error;
    if (!temporary_.empty()) fs::remove_all(temporary_, error);
}

void NewDatasetDirectory::check_target() const {
    std::error_code error;
    if (!fs::exists(target_, error)) return;
    if (!overwrite_) refuse(target_, "exists already; --force replaces it, or choose another name");
    if (!fs::is_directory(target_, error) ||
        !(fs::exists(target_ / layout::commit_marker, error) || fs::is_empty(target_, error)))
        refuse(target_, "exists and is not a CIEL dataset, so it is not overwritten; choose another name");
}

void NewDatasetDirectory::commit() {
    sync_filesystem(temporary_);
    check_target(); // checked again, because the target may have been created meanwhile
    const auto rename = [&](unsigned flags) {
        return ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), flags) == 0;
    };
    // Some file systems do not support the flags of renameat2. A rename without flags replaces only an empty directory.
    const bool exists = fs::exists(target_);
    bool done = rename(exists ? RENAME_EXCHANGE : RENAME_NOREPLACE);
    if (!done && errno == EINVAL) {
        if (exists) fs::remove_all(target_);
        done = rename(0);
    }
    if (!done) refuse_errno(target_, "cannot be replaced by the new dataset");
    sync_directory(target_.parent_path());
    std::error_code error;
    if (exists) fs::remove_all(temporary_, error); // after the exchange, temporary_ has the old dataset
    temporary_.clear();
}

} // namespace server::store
