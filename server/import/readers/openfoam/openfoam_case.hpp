// The directories of an OpenFOAM case: times, regions, and processors if the case is decomposed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace server::importer {

// A directory with a mesh: the case, or one processor's directory of a decomposed case.
struct FoamRoot {
    std::int64_t processor = 0;
    std::string name; // "processor3"; empty for a whole case
    std::filesystem::path directory;
    std::map<double, std::filesystem::path> times;
    std::map<std::string, std::map<double, std::filesystem::path>> mesh_times; // by region: times with a polyMesh

    // Returns the file in the latest time directory that has it and is not after `time`, or else the file in
    // `constant`. Returns an empty path if the file does not exist at all.
    [[nodiscard]] std::filesystem::path mesh_file(const std::string& region, const std::string& file,
                                                  double time) const;
};

struct FoamCase {
    // `input`: the directory of the case, its controlDict, or a file in this directory. Throws Error if the only mesh
    // is in collated files (processorsN).
    explicit FoamCase(const std::filesystem::path& input);

    std::filesystem::path directory;
    bool is_decomposed = false;
    std::vector<FoamRoot> roots;
    std::vector<double> times;        // times of all roots, ascending, at least one
    std::vector<std::string> regions; // "" is the region without a name
    std::vector<std::string> notes;
    std::vector<std::string> lost; // sentences on missing processor directories
};

[[nodiscard]] std::string missing_processor(std::int64_t number);

// Throws Error naming the file if a mesh or field file of the case is a pipe, a socket or a device.
void require_regular_files_of(const FoamCase& foam);

[[nodiscard]] bool is_foam_case(const std::filesystem::path& input, bool is_directory, const std::string& extension);

// Returns `file`, or `file` with .gz appended, whichever exists first; or else an empty path.
[[nodiscard]] std::filesystem::path plain_or_compressed(const std::filesystem::path& file);

// Returns the first `most` bytes of a file, decompressed if it is a .gz file. Throws Error that names the file if it
// cannot be read, or is a pipe, a socket or a device.
[[nodiscard]] std::string read_foam_file(const std::filesystem::path& file, std::size_t most = ~std::size_t{0});

} // namespace server::importer
