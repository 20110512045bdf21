// A file that is damaged in place, as nobody should, while it is mapped.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ciel::test {

enum class Damage { truncated, halved, overwritten, ones, flipped };

[[nodiscard]] std::string name_of(Damage damage);
// In place, by system calls: the mapping of the same file sees it at once. Always the same bytes for the same `seed`.
void damage(const std::filesystem::path& file, Damage how, unsigned seed);
// In place too, with the old size.
void rewrite(const std::filesystem::path& file, const std::string& content);
// As a writer should: a new file beside it, renamed.
void replace(const std::filesystem::path& file, const std::string& content);

// The files of a dataset that are mapped: of the topology, of positions and of the arrays at the first step.
[[nodiscard]] std::vector<std::filesystem::path> mapped_files_in(const std::filesystem::path& dataset); // relative
// Whether its content is indices, which are never taken for others unnoticed.
[[nodiscard]] bool holds_indices(const std::filesystem::path& relative);

} // namespace ciel::test
