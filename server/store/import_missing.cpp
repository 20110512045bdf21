#include "store/import_missing.hpp"

#include "ciel/types.hpp"
#include "store/files.hpp"
#include "store/layout.hpp"

#include <algorithm>
#include <set>

namespace ciel::store {
namespace {

namespace fs = std::filesystem;
constexpr const char* extension = ".ciel";

bool is_dataset(const fs::path& path) { return fs::exists(path / layout::commit_marker); }

bool holds_datasets(const fs::path& folder) {
    const auto entries = fs::directory_iterator(folder);
    return std::any_of(begin(entries), end(entries), [](const auto& entry) { return is_dataset(entry.path()); });
}

fs::path without_slash(const fs::path& path) {
    const fs::path whole = fs::absolute(path).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

// "run.vtu.series" and "run.vtu" are both "run"; a directory keeps its dots.
std::string dataset_name(const fs::path& input) {
    if (fs::is_directory(input)) return input.filename().string();
    fs::path name = input.stem();
    if (input.extension() == ".series") name = name.stem();
    return name.string();
}

// A case directory is as new as the newest thing in it: time steps come as new folders.
fs::file_time_type newest(const fs::path& input) {
    fs::file_time_type time = fs::last_write_time(input);
    if (fs::is_directory(input))
        for (const auto& entry : fs::directory_iterator(input)) time = std::max(time, entry.last_write_time());
    return time;
}

} // namespace

std::vector<fs::path> import_missing(const std::vector<fs::path>& data, const fs::path& folder,
                                     const ImportLimits& limits, const ImportListener& listener,
                                     const std::atomic<bool>& cancel) {
    std::vector<fs::path> served;
    std::set<fs::path> targets;
    for (const fs::path& path : data) {
        const fs::path input = without_slash(path);
        if (!fs::exists(input)) throw Error(path.string() + ": there is no such file or directory");
        if (input.extension() == extension || (fs::is_directory(input) && holds_datasets(input))) {
            served.push_back(input);
            continue;
        }
        const fs::path target = without_slash(folder) / (dataset_name(input) + extension);
        if (!targets.insert(target).second)
            throw Error(path.string() + ": another input is named " + dataset_name(input) +
                        " too; import one of them with ciel import -o NAME.ciel");
        served.push_back(target);
        if (is_dataset(target) && fs::last_write_time(target / layout::commit_marker) >= newest(input)) continue;
        make_directory(folder);
        const ImportValues values{{"inputs", {input.string()}}, {"output", {target.string()}}, {"force", {"yes"}}};
        const ImportEnd end = run_import(values, limits, listener, cancel);
        if (end.exit_code == 1 || end.exit_code == 2) throw Error(end.problem);
        if (!end.problem.empty()) listener.line(end.problem);
    }
    return served;
}

} // namespace ciel::store
