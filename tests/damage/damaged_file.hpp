// Damages a mapped file in place.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ciel::test {

enum class Damage { truncated, halved, overwritten, ones, flipped };

[[nodiscard]] std::string name_of(Damage damage);
// Changes the file in place by system calls, so existing mappings see the change. Equal seeds give equal bytes.
void damage(const std::filesystem::path& file, Damage how, unsigned seed);
// Overwrites the file in place with content of the same size.
void rewrite(const std::filesystem::path& file, const std::string& content);
// Writes a new file beside the old one and renames it, as a correct writer does.
void replace(const std::filesystem::path& file, const std::string& content);

// Mapped files of a dataset: topology, both sets of positions, and the arrays at the first step.
// Paths relative to the dataset.
[[nodiscard]] std::vector<std::filesystem::path> mapped_files_in(const std::filesystem::path& dataset);
// True for files of indices, whose damage is always detected.
[[nodiscard]] bool holds_indices(const std::filesystem::path& relative);

} // namespace ciel::test
