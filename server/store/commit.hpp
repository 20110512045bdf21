// Commits the steps of a dataset that is being written: the marker, and the table to which it moves them.
#pragma once

#include "store/format/marker.hpp"

#include <filesystem>
#include <string>

namespace ciel::store {

// One writer at a time: the caller holds the lock of the dataset, or the dataset is new.
struct Commit {
    std::filesystem::path directory;
    std::string dataset_id;
    bool is_appending = false; // else the files are new, and are flushed later

    // Replaces the marker. Throws FileError when it cannot be written.
    void put(const Marker& marker) const;
    // Moves the steps of the marker to the table when they are many, so that the marker stays small, and commits that.
    // Returns whether it did. Throws Error, with `marker` unchanged, when a file cannot be written.
    bool move_steps_to_table(Marker& marker) const;
    // Call when move_steps_to_table has failed: it may have replaced the marker before.
    void read_table_again(Marker& marker) const noexcept;
};

} // namespace ciel::store
