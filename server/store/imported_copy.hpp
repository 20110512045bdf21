// Copies that `ciel serve` imports for itself. A copy is replaced when its input changes, and steps that were appended
// to it would be lost.
#pragma once

#include <filesystem>
#include <string>

namespace ciel::store {

// Writes a file beside `dataset` that says what it is a copy of. Throws Error.
void mark_as_copy(const std::filesystem::path& dataset, const std::filesystem::path& input);

// What `dataset` is such a copy of; empty when it is none. Throws Error when the file beside it cannot be read.
[[nodiscard]] std::string input_of_copy(const std::filesystem::path& dataset);

} // namespace ciel::store
