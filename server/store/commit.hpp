// Commits the steps of a dataset that is being written: replaces the commit marker, and moves steps from it to the
// table of steps.
#pragma once

#include "store/format/marker.hpp"

#include <filesystem>
#include <string>

namespace ciel::store {

// One writer at a time: the caller holds the lock of the dataset, or the dataset is new.
struct Commit {
    std::filesystem::path directory;
    std::string dataset_id;
    bool is_appending = false; // false: the dataset is new, and its files are flushed later

    // Replaces the marker. Throws FileError when it cannot be written.
    void put(const Marker& marker) const;
    // If the marker has many steps, moves them to the table and replaces the marker, which stays small. Returns whether
    // it moved them. Throws Error, with `marker` unchanged, when a file cannot be written.
    bool move_steps_to_table(Marker& marker) const;
    // Reads the marker from the disk again. Call it when move_steps_to_table has failed, possibly after it has replaced
    // the marker.
    void read_table_again(Marker& marker) const noexcept;
};

} // namespace ciel::store
