#include "import/source_facts.hpp"

#include "importing/freshness.hpp"
#include "store/format/json_reader.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace server::importer {
namespace {

namespace fs = std::filesystem;

std::int64_t last_change(const std::vector<std::string>& inputs) {
    fs::file_time_type newest = fs::file_time_type::min();
    for (const std::string& input : inputs) newest = std::max(newest, importing::last_change(input));
    const auto since_1970 = std::chrono::file_clock::to_sys(newest).time_since_epoch();
    return std::max<std::int64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(since_1970).count(), 0);
}

} // namespace

SourceFacts::SourceFacts(const Options& options) {
    for (const std::string& input : options.inputs)
        source_.inputs.push_back(fs::absolute(input).lexically_normal().string());
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

bool SourceFacts::is_unchanged() const {
    const auto is_text = [](const std::string& input) { return store::valid_utf8(input) == input; };
    return std::ranges::all_of(source_.inputs, is_text) && last_change(source_.inputs) == source_.changed;
}

void SourceFacts::check_unchanged() const {
    if (source_.inputs.empty()) throw ciel::Error("the dataset does not name the source of its missing steps");
    for (const std::string& input : source_.inputs) {
        std::error_code error;
        if (!fs::exists(input, error))
            throw ciel::Error(input +
                              ": is not there any more, and the dataset has only some of its steps; put it back");
    }
    if (last_change(source_.inputs) != source_.changed)
        throw ciel::Error(source_.inputs.front() +
                          ": has changed since it was imported; import it again with `ciel import --force`");
}

} // namespace server::importer
