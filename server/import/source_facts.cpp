#include "import/source_facts.hpp"

#include "importing/freshness.hpp"
#include "store/format/checksum.hpp"
#include "store/format/json_reader.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <span>
#include <sys/stat.h>

namespace server::importer {
namespace {

namespace fs = std::filesystem;

std::int64_t last_change(const std::vector<std::string>& inputs) {
    fs::file_time_type newest = fs::file_time_type::min();
    for (const std::string& input : inputs) newest = std::max(newest, importing::last_change(input));
    const auto since_1970 = std::chrono::file_clock::to_sys(newest).time_since_epoch();
    return std::max<std::int64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(since_1970).count(), 0);
}

// Adds the names, sizes and times of a file, or of the files in a directory. Returns false if the path does not exist.
bool add_files(const fs::path& path, std::vector<std::string>& files) {
    struct stat facts {};
    if (::stat(path.c_str(), &facts) != 0) return false;
    if (S_ISREG(facts.st_mode))
        files.push_back(fs::absolute(path).lexically_normal().string() + '\0' + std::to_string(facts.st_size) + ' ' +
                        std::to_string(facts.st_mtim.tv_sec) + ' ' + std::to_string(facts.st_mtim.tv_nsec) + '\0');
    if (!S_ISDIR(facts.st_mode)) return true;
    std::error_code error;
    for (auto entry = fs::directory_iterator(path, error); !error && entry != fs::directory_iterator();
         entry.increment(error))
        if (!fs::is_directory(entry->path(), error)) add_files(entry->path(), files);
    return !error;
}

// Returns a checksum of names, sizes and times; an empty text if the files are not known or one of them is missing.
std::string state_of_files(const Source& source, std::size_t step, const std::set<std::string>& names) {
    std::vector<std::string> files;
    try {
        for (const fs::path& path : source.files_of(step, names))
            if (!add_files(path, files)) return {};
    } catch (const ciel::Error&) { // a file is missing or has an unknown format
        return {};
    } catch (const fs::filesystem_error&) { // a directory cannot be searched
        return {};
    }
    if (files.empty()) return {};
    std::ranges::sort(files);
    std::string all;
    for (const std::string& file : files) all += file;
    return store::checksum(std::as_bytes(std::span(all)));
}

fs::path absolute_without_slash(const std::string& input) {
    const fs::path path = fs::absolute(input).lexically_normal();
    return path.has_filename() ? path : path.parent_path();
}

} // namespace

SourceFacts::SourceFacts(const Options& options) {
    for (const std::string& input : options.inputs) source_.inputs.push_back(absolute_without_slash(input).string());
    if (!options.arrays.empty()) source_.options["array"] = options.arrays;
    if (!options.source.plot3d.empty()) source_.options["plot3d"] = {options.source.plot3d};
    if (options.weld == Weld::all) source_.options["weld"] = {"yes"};
    if (options.weld == Weld::none) source_.options["no-weld"] = {"yes"};
    source_.changed = last_change(source_.inputs);
}

std::vector<std::string> SourceFacts::arrays() const {
    const auto found = source_.options.find("array");
    return found == source_.options.end() ? std::vector<std::string>{} : found->second;
}

Weld SourceFacts::weld() const {
    if (source_.options.contains("weld")) return Weld::all;
    return source_.options.contains("no-weld") ? Weld::none : Weld::seams;
}

SourceOptions SourceFacts::source_options() const {
    const auto found = source_.options.find("plot3d");
    return {found == source_.options.end() ? std::string() : found->second.at(0)};
}

bool SourceFacts::has_files() const {
    return std::ranges::any_of(source_.files, [](const std::string& of_step) { return !of_step.empty(); });
}

void SourceFacts::set_arrays(std::span<const store::ArrayInfo> arrays) {
    for (const store::ArrayInfo& array : arrays) {
        const fs::path file = fs::path(array.source.file).filename();
        names_.insert((file.extension() == ".gz" ? file.stem() : file).string());
    }
}

void SourceFacts::add_late_step(const Source& source, std::size_t step_of_source) {
    source_.files.push_back(state_of_files(source, step_of_source, names_));
}

bool SourceFacts::can_be_stored() const {
    return std::ranges::all_of(source_.inputs,
                               [](const std::string& input) { return store::valid_utf8(input) == input; });
}

bool SourceFacts::is_current(const Source& source) const {
    return !state_of_files(source, 0, names_).empty() || last_change(source_.inputs) == source_.changed;
}

void SourceFacts::check_inputs() const {
    if (source_.inputs.empty()) throw ciel::Error("the dataset does not name the source of its missing steps");
    for (const std::string& input : source_.inputs) {
        std::error_code error;
        if (!fs::exists(input, error))
            throw ciel::Error(input +
                              ": is not there any more, and the dataset has only some of its steps; put it back");
    }
}

std::string SourceFacts::state_of(const Source& source, std::size_t step_of_source) const {
    return has_files() ? state_of_files(source, step_of_source, names_) : std::to_string(last_change(source_.inputs));
}

std::string SourceFacts::state_at_import(std::size_t step_of_dataset) const {
    if (!has_files()) return std::to_string(source_.changed);
    return step_of_dataset < source_.files.size() ? source_.files[step_of_dataset] : std::string();
}

} // namespace server::importer
