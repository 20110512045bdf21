#include "import/readers/openfoam/openfoam_case.hpp"

#include "ciel/types.hpp"
#include "import/readers/regular_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <zlib.h>

namespace server::importer {

namespace {

namespace fs = std::filesystem;
constexpr int most_missing_told = 100; // largest number of missing processors to report for one gap in the numbering

std::optional<double> as_time(const std::string& name) {
    double time = 0;
    const char* const end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data(), end, time);
    if (error != std::errc{} || stop != end || !std::isfinite(time)) return std::nullopt;
    return time;
}

std::map<double, fs::path> times_in(const fs::path& directory) {
    std::map<double, fs::path> times;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(directory, missing)) {
        if (!entry.is_directory()) continue;
        if (const auto time = as_time(entry.path().filename().string())) times.emplace(*time, entry.path());
    }
    return times;
}

double latest_time(const fs::path& directory) {
    const auto times = times_in(directory);
    return times.empty() ? -std::numeric_limits<double>::infinity() : times.rbegin()->first;
}

fs::path case_directory(const fs::path& input, bool is_directory) {
    if (is_directory) return input;
    if (input.filename() == "controlDict") return fs::absolute(input).parent_path().parent_path();
    return fs::absolute(input).parent_path();
}

// A directory such as "processors4" has the pieces of all processors in one file. Returns "" if there is none.
std::string collated_directory(const fs::path& directory) {
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(directory, missing)) {
        std::string name = entry.path().filename().string();
        if (entry.is_directory() && name.starts_with("processors") && name.size() > 10) return name;
    }
    return "";
}

bool has_mesh(const fs::path& directory) {
    return fs::exists(directory / "constant/polyMesh") || fs::exists(directory / "constant/regionProperties");
}

std::set<std::string> regions_in(const fs::path& directory) {
    std::set<std::string> regions;
    std::error_code missing;
    if (fs::exists(directory / "constant/polyMesh")) regions.insert("");
    for (const auto& entry : fs::directory_iterator(directory / "constant", missing))
        if (fs::exists(entry.path() / "polyMesh")) regions.insert(entry.path().filename().string());
    return regions;
}

std::map<double, fs::path> times_with_mesh(const FoamRoot& root, const std::string& region) {
    std::map<double, fs::path> found;
    std::error_code missing;
    for (const auto& [time, directory] : root.times)
        if (fs::exists(directory / region / "polyMesh", missing)) found.emplace(time, directory);
    return found;
}

std::vector<int> processors_in(const fs::path& directory) {
    constexpr std::string_view prefix = "processor";
    std::vector<int> numbers;
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(directory, missing)) {
        const std::string name = entry.path().filename().string();
        int number = 0;
        const char* const end = name.data() + name.size();
        if (!entry.is_directory() || !name.starts_with(prefix)) continue;
        const auto [stop, error] = std::from_chars(name.data() + prefix.size(), end, number);
        if (error == std::errc{} && stop == end) numbers.push_back(number);
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

class GzipFile {
public:
    explicit GzipFile(const fs::path& file) : file_(gzopen(file.c_str(), "rb")) {}
    GzipFile(const GzipFile&) = delete;
    GzipFile& operator=(const GzipFile&) = delete;
    ~GzipFile() {
        if (file_ != nullptr) gzclose(file_);
    }
    [[nodiscard]] bool is_open() const { return file_ != nullptr; }
    // Returns the number of bytes read, 0 at the end, -1 if the data is damaged.
    int read(char* buffer, unsigned bytes) { return gzread(file_, buffer, bytes); }
    [[nodiscard]] bool ended_well() {
        int error = Z_OK;
        gzerror(file_, &error);
        return error == Z_OK || error == Z_STREAM_END;
    }

private:
    gzFile file_;
};

std::string read_gzip(const fs::path& path, std::size_t most) {
    constexpr std::size_t chunk = 1U << 20;
    GzipFile file(path);
    if (!file.is_open())
        throw ciel::Error(path.string() + ": cannot be opened; check that it exists and that you may read it");
    std::string bytes;
    while (bytes.size() < most) {
        const std::size_t begin = bytes.size();
        const std::size_t wanted = std::min(chunk, most - begin);
        bytes.resize(begin + wanted);
        const int got = file.read(bytes.data() + begin, static_cast<unsigned>(wanted));
        if (got < 0 || (got == 0 && !file.ended_well()))
            throw ciel::Error(path.string() +
                              ": is damaged: its compressed data ends too early or is wrong; copy the file again");
        bytes.resize(begin + static_cast<std::size_t>(got));
        if (got == 0) break;
    }
    return bytes;
}

} // namespace

std::string missing_processor(std::int64_t number) {
    return "The directory processor" + std::to_string(number) + " is missing: its part of the mesh was left out.";
}

fs::path FoamRoot::mesh_file(const std::string& region, const std::string& file, double time) const {
    const auto& of_region = mesh_times.at(region);
    for (auto at = of_region.upper_bound(time); at != of_region.begin();) {
        --at;
        fs::path of_time = plain_or_compressed(at->second / region / "polyMesh" / file);
        if (!of_time.empty()) return of_time;
    }
    return plain_or_compressed(directory / "constant" / region / "polyMesh" / file);
}

FoamCase::FoamCase(const fs::path& input) : directory(case_directory(input, fs::is_directory(input))) {
    const std::vector<int> processors = processors_in(directory);
    const std::string collated = collated_directory(directory);
    if (!has_mesh(directory) && processors.empty())
        throw ciel::Error(input.string() + ": is decomposed into collated files (" + collated +
                          "), which cannot be read; run reconstructPar on the case");
    double latest_of_processors = -std::numeric_limits<double>::infinity();
    for (const int number : processors)
        latest_of_processors =
            std::max(latest_of_processors, latest_time(directory / ("processor" + std::to_string(number))));
    is_decomposed = !processors.empty() && (!has_mesh(directory) || latest_of_processors > latest_time(directory));
    if (is_decomposed && has_mesh(directory))
        notes.emplace_back(
            "The processor directories were read, because they have later times than the reconstructed case.");
    if (!is_decomposed && !collated.empty() && latest_time(directory / collated) > latest_time(directory))
        notes.push_back("The later times in " + collated +
                        " (collated files) were not read; run reconstructPar on the case to read them.");

    if (!is_decomposed) roots.push_back({0, "", directory, {}, {}});
    int expected = 0;
    for (const int number : processors) {
        if (!is_decomposed) break;
        for (int missing = expected; missing < number && missing < expected + most_missing_told; ++missing)
            lost.push_back(missing_processor(missing));
        expected = number + 1;
        const std::string name = "processor" + std::to_string(number);
        roots.push_back({number, name, directory / name, {}, {}});
    }
    std::set<std::string> all_regions;
    std::set<double> all_times;
    for (FoamRoot& root : roots) {
        root.times = times_in(root.directory);
        for (const auto& [time, path] : root.times) all_times.insert(time);
        all_regions.merge(regions_in(root.directory));
    }
    times.assign(all_times.begin(), all_times.end());
    regions.assign(all_regions.begin(), all_regions.end());
    if (times.empty()) times = {0};
    for (FoamRoot& root : roots)
        for (const std::string& region : regions) root.mesh_times[region] = times_with_mesh(root, region);
}

void require_regular_files_of(const FoamCase& foam) {
    require_regular(foam.directory / "system/controlDict");
    for (const FoamRoot& root : foam.roots)
        for (const std::string& region : foam.regions) {
            require_regular_files(root.directory / "constant" / region / "polyMesh");
            for (const auto& [time, directory] : root.times) {
                require_regular_files(directory / region);
                require_regular_files(directory / region / "polyMesh");
            }
        }
}

bool is_foam_case(const fs::path& input, bool is_directory, const std::string& extension) {
    if (!is_directory && extension != ".foam" && input.filename() != "controlDict") return false;
    const fs::path directory = case_directory(input, is_directory);
    return has_mesh(directory) || !processors_in(directory).empty() ||
           (is_directory && !collated_directory(directory).empty());
}

fs::path plain_or_compressed(const fs::path& file) {
    if (fs::exists(file)) return file;
    fs::path compressed = file;
    compressed += ".gz";
    return fs::exists(compressed) ? compressed : fs::path();
}

std::string read_foam_file(const fs::path& file, std::size_t most) {
    require_regular(file);
    if (file.extension() == ".gz") return read_gzip(file, most);
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw ciel::Error(file.string() + ": cannot be opened; check that it exists and that you may read it");
    std::string bytes(std::min<std::uintmax_t>(fs::file_size(file), most), '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    return bytes;
}

} // namespace server::importer
