#include "store/freshness.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

namespace ciel::store {
namespace {

namespace fs = std::filesystem;
using Time = fs::file_time_type;

// A running simulation may take a file away while it is looked at.
Time time_of(const fs::path& path) {
    std::error_code error;
    const Time time = fs::last_write_time(path, error);
    return error ? Time::min() : time;
}

Time newest_below(const fs::path& directory) {
    Time newest = time_of(directory); // a file more or less
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

// constant/polyMesh, and constant/REGION/polyMesh.
Time newest_mesh(const fs::path& constant) {
    Time newest = newest_below(constant / "polyMesh");
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(constant, error))
        newest = std::max(newest, newest_below(entry.path() / "polyMesh"));
    return newest;
}

// The case itself, or the part of it that one processor wrote.
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

Time last_change(const fs::path& input) {
    const fs::path directory = case_of(input);
    if (is_openfoam_case(directory)) return newest_of_case(directory);
    Time newest = time_of(input);
    for (const char* extension : {".q", ".Q"})
        newest = std::max(newest, time_of(fs::path(input).replace_extension(extension)));
    return newest;
}

} // namespace ciel::store
