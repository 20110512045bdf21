// Commits the steps of a dataset that is being written: replaces the commit marker (steps.json), and moves steps to the
// table of steps (format/step_table.hpp).
#pragma once

#include "store/format/marker.hpp"

#include <filesystem>
#include <string>

namespace server::store {

// Only one writer may use a dataset at a time: the caller holds the lock of the dataset, or the dataset is new.
struct Commit {
    std::filesystem::path directory;
    std::string dataset_id;
    bool is_appending = false; // false: the dataset is new, and its files are flushed later

    void put(const Marker& marker) const;
    // If the marker has more than 64 steps, moves all of them to the table and replaces the marker. Returns true if it
    // moved steps. Throws Error when a file cannot be written; `marker` is then unchanged.
    bool move_steps_to_table(Marker& marker) const;
    // Reads the marker from the disk again. Call it after move_steps_to_table has thrown, because that function may
    // have replaced the marker on the disk before it failed. If the marker cannot be read, `marker` is unchanged.
    void read_table_again(Marker& marker) const noexcept;
};

} // namespace server::store
