// Marks datasets that `ciel serve` imported for itself. Such a copy is imported again when its input changes, so steps
// appended to it would be lost.
#pragma once

#include <filesystem>
#include <string>

namespace server::store {

// Writes a file beside `dataset` that marks it as a copy of `input`. Throws Error when the file cannot be written.
void mark_as_copy(const std::filesystem::path& dataset, const std::filesystem::path& input);

// Returns the input from which `dataset` was imported; an empty text if `dataset` is not marked as a copy. Throws Error
// when the mark cannot be read.
[[nodiscard]] std::string input_of_copy(const std::filesystem::path& dataset);

} // namespace server::store
