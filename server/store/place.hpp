// Place: the path of a new dataset. The dataset is written to a temporary directory beside that path, which is renamed
// when the dataset is complete.
#pragma once

#include "store/files/files.hpp"

namespace ciel::store {

// Removes the temporary directories of killed writers of `target`. Those of running writers are locked and stay.
void remove_left_behind(const std::filesystem::path& target);

// Throws Error if the constructor of Place would, and leaves no directory. For callers that do long work before they
// write.
void check_place(const std::filesystem::path& target, bool overwrite);

class Place {
public:
    // Makes the temporary directory, and removes those of killed writers of the same target. Throws Error when the
    // target exists and `overwrite` is false, or when it is neither a dataset nor an empty directory. Also throws Error
    // when the target's parent directory does not exist or cannot be written.
    Place(const std::filesystem::path& target, bool overwrite);
    ~Place(); // without commit(): removes the temporary directory
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    [[nodiscard]] const std::filesystem::path& target() const { return target_; }
    [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }
    // Flushes the temporary directory to the disk and renames it to the target. An existing dataset is exchanged in one
    // step and then deleted; programs that have mapped its files can still read them. Throws Error when the rename
    // fails.
    void commit();

private:
    void check_target() const;
    void make_temporary();

    std::filesystem::path target_, temporary_;
    bool overwrite_;
    Descriptor lock_; // lock on the temporary directory, by which remove_left_behind knows that it is in use
};

} // namespace ciel::store
