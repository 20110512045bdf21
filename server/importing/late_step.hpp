// Reads the late arrays of a step from the source of an import.
#pragma once

#include "importing/importer.hpp"
#include "store/dataset.hpp"

#include <atomic>
#include <filesystem>
#include <string>

namespace server::importing {

// Runs ciel-import, which writes the arrays into the dataset, or below `folder` if the dataset cannot be written to.
// Returns the error sentence without the names of folders; empty on success. If no array of the step is late any more,
// waits for 0.2 s instead. Ends soon after `cancel` is set. Thread-safe.
[[nodiscard]] std::string read_late_step(const store::Dataset& dataset, std::size_t step,
                                         const std::filesystem::path& folder, const ImportLimits& limits,
                                         const std::atomic<bool>& cancel);

} // namespace server::importing
