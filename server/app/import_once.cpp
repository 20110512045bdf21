#include "app/import_once.hpp"

#include "ciel/types.hpp"
#include "store/importer.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <functional>
#include <spdlog/spdlog.h>

namespace ciel::app {
namespace {

namespace fs = std::filesystem;

bool is_foreign(const fs::path& path) {
    if (!fs::is_directory(path)) return true;
    return fs::exists(path / "system" / "controlDict"); // an OpenFOAM case; other directories hold datasets
}

// Differs when the source does: its time of change and size, or those of its case's control file.
std::string version_of(const fs::path& source) {
    const fs::path file = fs::is_directory(source) ? source / "system" / "controlDict" : source;
    const std::string text = source.string() + "\n" + std::to_string(fs::file_size(file)) + "\n" +
                             std::to_string(fs::last_write_time(file).time_since_epoch().count());
    std::string digits;
    for (std::size_t hash = std::hash<std::string>{}(text); hash > 0; hash /= 16)
        digits += "0123456789abcdef"[hash % 16];
    return digits;
}

void import_now(const fs::path& source, const fs::path& output) {
    spdlog::info("importing {}", source.string());
    int shown_tenth = 0;
    const store::ImportListener listener{
        [&](double share, const std::string& phase) {
            const int percent = static_cast<int>(std::clamp(share, 0.0, 1.0) * 100);
            if (percent / 10 == shown_tenth) return;
            shown_tenth = percent / 10;
            spdlog::info("importing {}: {} % {}", source.filename().string(), percent, phase);
        },
        [&](const std::string& line) { spdlog::info("importing {}: {}", source.filename().string(), line); }};
    const std::atomic<bool> cancel{false};
    const store::ImportEnd end =
        store::run_import({{"inputs", {source.string()}}, {"output", {output.string()}}}, {}, listener, cancel);
    if (end.exit_code == 3)
        spdlog::warn("{}", end.problem);
    else if (end.exit_code != 0) {
        fs::remove(output.parent_path());
        throw Error(end.problem);
    }
}

} // namespace

fs::path import_once(const fs::path& path, const fs::path& folder) {
    if (!fs::exists(path))
        throw Error(path.string() + " does not exist; name a dataset, a folder of datasets or a file to import");
    if (!is_foreign(path)) return path;
    const fs::path source = fs::canonical(path);
    const fs::path output = folder / version_of(source) / (source.stem().string() + ".ciel");
    if (fs::exists(output)) return output;
    fs::create_directories(output.parent_path());
    import_now(source, output);
    return output;
}

fs::path default_import_folder() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache != '\0')
        return fs::path(cache) / "ciel";
    const char* home = std::getenv("HOME");
    return fs::path(home != nullptr ? home : ".") / ".cache" / "ciel";
}

} // namespace ciel::app
