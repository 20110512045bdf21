// Place: the path of a new dataset. The dataset is first written to a temporary directory beside the path. When the
// dataset is complete, the temporary directory is renamed to the path.
#pragma once

#include "store/files/files.hpp"

namespace ciel::store {

// Removes the temporary directories that killed writers of `target` have left. The temporary directories of running
// writers are locked and are not removed.
void remove_left_behind(const std::filesystem::path& target);

// Throws Error if the constructor of Place would throw. Leaves no temporary directory. Lets a caller detect a bad
// target before a long computation.
void check_place(const std::filesystem::path& target, bool overwrite);

class Place {
public:
    // Makes the temporary directory, and removes those that killed writers of the same target have left. Throws Error
    // when the target exists and `overwrite` is false, or when the target is neither a dataset nor an empty directory.
    // Also throws Error when the target's parent directory does not exist or cannot be written.
    Place(const std::filesystem::path& target, bool overwrite);
    ~Place(); // without commit(): removes the temporary directory
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    [[nodiscard]] const std::filesystem::path& target() const { return target_; }
    [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }
    // Flushes the temporary directory to the disk and renames it to the target. If a dataset exists at the target, both
    // directories are exchanged and the old dataset is deleted. Programs that have mapped files of the old dataset can
    // still read them. Throws Error when the rename fails.
    void commit();

private:
    void check_target() const;
    void make_temporary();

    std::filesystem::path target_, temporary_;
    bool overwrite_;
    Descriptor lock_; // lock on the temporary directory; remove_left_behind skips locked directories
};

} // namespace ciel::store
