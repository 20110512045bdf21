// The directory of a new dataset. The dataset is first written to a temporary directory beside the final path. When the
// dataset is complete, the temporary directory is renamed to the final path.
#pragma once

#include "store/files/files.hpp"

namespace server::store {

// Removes the temporary directories of killed writers. Those of running writers are locked and are not removed.
void remove_left_behind(const std::filesystem::path& target);

// Throws Error if the constructor of NewDatasetDirectory would throw. Allows a check before a long computation.
void check_new_dataset_directory(const std::filesystem::path& target, bool overwrite);

class NewDatasetDirectory {
public:
    // Also removes the temporary directories of killed writers. Throws Error when the target exists and `overwrite` is
    // false, when it is neither a dataset nor an empty directory, or when its parent directory cannot be written.
    NewDatasetDirectory(const std::filesystem::path& target, bool overwrite);
    ~NewDatasetDirectory(); // without commit(): removes the temporary directory
    NewDatasetDirectory(const NewDatasetDirectory&) = delete;
    NewDatasetDirectory& operator=(const NewDatasetDirectory&) = delete;

    [[nodiscard]] const std::filesystem::path& target() const { return target_; }
    [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }
    // Flushes the temporary directory and renames it to the target. A dataset at the target is deleted, but programs
    // that have mapped its files can still read them. Throws Error when the rename fails.
    void commit();

private:
    void check_target() const;
    void make_temporary();

    std::filesystem::path target_, temporary_;
    bool overwrite_;
    Descriptor lock_; // lock on the temporary directory; remove_left_behind skips locked directories
};

} // namespace server::store
