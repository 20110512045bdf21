// Where an OpenFOAM case keeps what: its times, its regions, and its processors' directories when it is decomposed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ciel::importer {

// A case that is whole, or what one processor has of it.
struct FoamPart {
    std::int64_t processor = 0;
    std::string name; // "processor3"; empty for a whole case
    std::filesystem::path directory;
    std::map<double, std::filesystem::path> times;

    // The file of the mesh that holds at a time: the latest one written until then. Empty where there is none.
    [[nodiscard]] std::filesystem::path mesh_file(const std::string& region, const std::string& file,
                                                  double time) const;
};

struct FoamCase {
    // The case's directory, its controlDict, or a file beside its directories. Throws Error where all pieces are in
    // collated files.
    explicit FoamCase(const std::filesystem::path& input);

    std::filesystem::path directory;
    bool is_decomposed = false;
    std::vector<FoamPart> parts;
    std::vector<double> times;        // of all parts, ascending, at least one
    std::vector<std::string> regions; // "" is the region without a name
    std::vector<std::string> notes;
    std::vector<std::string> lost; // sentences on processors whose directories are not there
};

// A sentence for FoamCase::lost.
[[nodiscard]] std::string missing_processor(std::int64_t number);

// Throws Error naming the file where a pipe or a device is among the files of the case's meshes and times.
void require_regular_files_of(const FoamCase& foam);

[[nodiscard]] bool is_foam_case(const std::filesystem::path& input, bool is_directory, const std::string& extension);

// `file` itself or the same with .gz; empty where there is neither.
[[nodiscard]] std::filesystem::path plain_or_compressed(const std::filesystem::path& file);

// All bytes, or the first `most` of them, decompressed where the name ends in .gz. Throws Error naming the file where
// it cannot be read, and where it is a pipe or a device.
[[nodiscard]] std::string read_foam_file(const std::filesystem::path& file, std::size_t most = ~std::size_t{0});

} // namespace ciel::importer
