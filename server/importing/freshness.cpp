#include "importing/freshness.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

namespace server::importing {
namespace {

namespace fs = std::filesystem;
using Time = fs::file_time_type;
constexpr std::string_view grid_ending = "xyz"; // NASA's names: grid "bluntfinxyz.bin", solution "bluntfinq.bin"

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

// Returns Time::min() on an error, because a running simulation may remove the file.
Time time_of(const fs::path& path) {
    std::error_code error;
    const Time time = fs::last_write_time(path, error);
    return error ? Time::min() : time;
}

Time newest_below(const fs::path& directory) {
    Time newest = time_of(directory); // the directory's own time changes when a file is added or removed
    std::error_code error;
    for (auto entry = fs::recursive_directory_iterator(directory, error);
         !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
        newest = std::max(newest, time_of(entry->path()));
    return newest;
}

bool is_time_directory(const std::string& name) {
    char* end = nullptr;
    std::strtod(name.c_str(), &end);
    return !name.empty() && *end == '\0';
}

Time newest_mesh(const fs::path& constant) {
    Time newest = newest_below(constant / "polyMesh");
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(constant, error))
        newest = std::max(newest, newest_below(entry.path() / "polyMesh"));
    return newest;
}

// `directory`: an OpenFOAM case, or a processor directory in a case.
Time newest_of_case(const fs::path& directory) {
    Time newest = std::max(time_of(directory / "system" / "controlDict"), newest_mesh(directory / "constant"));
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(directory, error)) {
        const std::string name = entry.path().filename().string();
        if (is_time_directory(name)) newest = std::max(newest, newest_below(entry.path()));
        if (name.starts_with("processor")) newest = std::max(newest, newest_of_case(entry.path()));
    }
    return newest;
}

fs::path case_of(const fs::path& input) {
    if (input.extension() == ".foam") return input.parent_path();
    if (input.filename() == "controlDict") return input.parent_path().parent_path();
    return input;
}

} // namespace

bool is_openfoam_case(const fs::path& directory) {
    constexpr std::array signs{"system/controlDict", "constant/polyMesh", "constant/regionProperties", "processor0"};
    return std::any_of(signs.begin(), signs.end(), [&](const char* sign) {
        std::error_code error;
        return fs::exists(directory / sign, error);
    });
}

std::vector<fs::path> plot3d_solutions(const fs::path& grid) {
    std::vector<fs::path> names{fs::path(grid).replace_extension(".q"), fs::path(grid).replace_extension(".Q")};
    if (const std::string stem = grid.stem().string(); stem.ends_with(grid_ending))
        names.push_back(fs::path(grid).replace_filename(stem.substr(0, stem.size() - grid_ending.size()) + "q" +
                                                        grid.extension().string()));
    std::erase_if(names, [&](const fs::path& name) { return name == grid || !is_file(name); });
    return names;
}

fs::path plot3d_grid(const fs::path& solution) {
    std::vector<fs::path> names;
    for (const char* extension : {".xyz", ".x", ".g", ".p3d"})
        names.push_back(fs::path(solution).replace_extension(extension));
    if (const std::string stem = solution.stem().string(); stem.ends_with('q'))
        names.push_back(fs::path(solution).replace_filename(stem.substr(0, stem.size() - 1) + std::string(grid_ending) +
                                                            solution.extension().string()));
    const auto found =
        std::ranges::find_if(names, [&](const fs::path& name) { return name != solution && is_file(name); });
    return found == names.end() ? fs::path() : *found;
}

Time last_change(const fs::path& input) {
    const fs::path directory = case_of(input);
    if (is_openfoam_case(directory)) return newest_of_case(directory);
    Time newest = time_of(input);
    for (const fs::path& file : plot3d_solutions(input)) newest = std::max(newest, time_of(file));
    if (const fs::path grid = plot3d_grid(input); !grid.empty()) newest = std::max(newest, time_of(grid));
    return newest;
}

} // namespace server::importing
