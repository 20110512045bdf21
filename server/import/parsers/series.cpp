#include "ciel/types.hpp"
#include "import/parsers/index_entry.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace server::importer {

namespace {

constexpr int max_depth = 16; // largest accepted nesting depth; the format needs a depth of 3

nlohmann::json parse_shallow(std::string_view text, const std::string& name) {
    bool too_deep = false;
    const auto callback = [&too_deep](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
        too_deep |= depth > max_depth;
        return depth <= max_depth;
    };
    nlohmann::json document = nlohmann::json::parse(text, callback, false);
    if (document.is_discarded()) throw ciel::Error(name + ": is not well-formed JSON");
    if (too_deep) throw ciel::Error(name + ": is nested too deeply for a file series");
    return document;
}

} // namespace

std::vector<IndexEntry> parse_series(std::string_view text, const std::string& name) {
    const nlohmann::json document = parse_shallow(text, name);
    if (!document.is_object() || !document.contains("files") || !document["files"].is_array())
        throw ciel::Error(name + ": is not a file series: it has no \"files\" list");

    std::vector<IndexEntry> entries;
    for (const nlohmann::json& file : document["files"]) {
        if (!file.is_object() || !file.contains("name") || !file["name"].is_string())
            throw ciel::Error(name + ": an entry of \"files\" has no \"name\"");
        IndexEntry entry{static_cast<double>(entries.size()), "", file["name"].get<std::string>()};
        if (file.contains("time")) {
            if (!file["time"].is_number()) throw ciel::Error(name + ": the time of " + entry.file + " is not a number");
            entry.time = file["time"].get<double>();
        }
        if (entry.file.empty() || !std::isfinite(entry.time))
            throw ciel::Error(name + ": an entry of \"files\" has an empty name or an infinite time");
        entries.push_back(std::move(entry));
    }
    if (entries.empty()) throw ciel::Error(name + ": names no files; list at least one data file");
    std::stable_sort(entries.begin(), entries.end(),
                     [](const IndexEntry& a, const IndexEntry& b) { return a.time < b.time; });
    return entries;
}

} // namespace server::importer
