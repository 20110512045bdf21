// The place where a new dataset comes to stand: written aside in a temporary sibling, renamed when whole.
#pragma once

#include "store/files/files.hpp"

namespace ciel::store {

// Removes the temporary directories of writers of `target` that died; those of living ones are locked and stay.
void remove_left_behind(const std::filesystem::path& target);

// Throws what Place would; leaves nothing. For those who have much to do before they write.
void check_place(const std::filesystem::path& target, bool overwrite);

class Place {
public:
    // Makes the temporary directory, and removes those that killed writers of the same target have left. Throws Error
    // when the target exists and `overwrite` is false, when it exists and is no dataset, or when the folder it is to
    // stand in does not exist or cannot be written.
    Place(const std::filesystem::path& target, bool overwrite);
    ~Place(); // without commit(): removes the temporary directory
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

    [[nodiscard]] const std::filesystem::path& target() const { return target_; }
    [[nodiscard]] const std::filesystem::path& temporary() const { return temporary_; }
    // Flushes everything to the disk, then renames. A dataset that stood there is exchanged in one step and deleted;
    // what has it mapped keeps it.
    void commit();

private:
    void check_target() const;
    void make_temporary();

    std::filesystem::path target_, temporary_;
    bool overwrite_;
    Descriptor lock_; // tells a temporary directory in use from one left behind
};

} // namespace ciel::store
