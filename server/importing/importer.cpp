#include "importing/importer.hpp"

#include "ciel/types.hpp"
#include "importing/import_end.hpp"
#include "processes/child_process.hpp"
#include "store/format/attributes.hpp"
#include "store/format/layout.hpp"
#include "store/new_dataset_directory.hpp"

#include <cstdlib>
#include <sstream>
#include <unistd.h>

namespace server::importing {
namespace {

namespace fs = std::filesystem;
constexpr const char* program = "ciel-import";
constexpr double gigabyte = 1e9;

std::vector<std::string> command_line(const ImportValues& values) {
    std::vector<std::string> arguments{find_import_program().string()};
    std::vector<std::string> positional;
    for (const ImportOption& option : import_options) {
        const auto given = values.find(std::string(option.name));
        if (given == values.end()) continue;
        for (const std::string& value : given->second) {
            if (option.required)
                positional.push_back(value);
            else if (option.value.empty())
                arguments.push_back("--" + std::string(option.name));
            else
                arguments.push_back("--" + std::string(option.name) + "=" + value);
        }
    }
    arguments.emplace_back("--"); // allows an input that begins with a dash
    arguments.insert(arguments.end(), positional.begin(), positional.end());
    return arguments;
}

void pass_line(std::string_view line, const ImportListener& listener) {
    constexpr std::string_view progress = "progress ";
    if (!line.starts_with(progress)) {
        listener.line(std::string(line));
        return;
    }
    const std::string rest(line.substr(progress.size()));
    char* phase = nullptr;
    const double share = std::strtod(rest.c_str(), &phase);
    listener.progress(share, *phase == ' ' ? phase + 1 : phase);
}

// Returns the id of a dataset, or an empty text if there is none.
std::string id_of(const fs::path& dataset) {
    const fs::path document = dataset / store::layout::attributes_document;
    std::error_code error;
    if (dataset.empty() || !fs::exists(document, error)) return {};
    try {
        return store::parse_root_attributes(store::read_text(document, store::layout::document_bytes), document).id;
    } catch (const ciel::Error&) { // not a dataset
        return {};
    }
}

} // namespace

fs::path find_import_program() {
    std::error_code error;
    fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path() / program;
    if (::access(beside.c_str(), X_OK) == 0) return beside;
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (fs::path found = fs::path(folder) / program; ::access(found.c_str(), X_OK) == 0) return found;
    throw ciel::Error(
        "ciel-import was not found beside ciel or on PATH; install the package ciel-import, or build it with "
        "-DCIEL_IMPORT=ON and VTK 9");
}

ImportLimits::ImportLimits()
    : memory_gigabytes(static_cast<double>(limits::Limits().import_memory_bytes) / gigabyte),
      stalled_seconds(static_cast<double>(limits::Limits().import_stalled_seconds)) {}

ImportLimits import_limits_of_server(const limits::Limits& limits) {
    ImportLimits result;
    result.memory_gigabytes = static_cast<double>(limits.import_memory_bytes) / gigabyte;
    result.stalled_seconds = static_cast<double>(limits.import_stalled_seconds);
    result.memory_option = "--limit-import-memory-bytes";
    result.stalled_option = "--limit-import-stalled-seconds";
    return result;
}

ImportEnd run_import(const ImportValues& values, const ImportLimits& limits, const ImportListener& listener,
                     const std::atomic<bool>& cancel) {
    if (cancel) { // cancelled before the import starts
        processes::ChildEnd end;
        end.cancelled = true;
        return {1, describe_end(end, values, limits)};
    }
    const auto output = values.find("output");
    const fs::path dataset = output != values.end() && !output->second.empty() ? output->second.back() : "";
    const std::string id_before = id_of(dataset);
    const auto memory = static_cast<std::uint64_t>(limits.memory_gigabytes * gigabyte);
    const processes::ChildEnd end = processes::run_child(
        command_line(values), {memory, limits.seconds, limits.stalled_seconds},
        [&](std::string_view line) { pass_line(line, listener); }, cancel);
    if (end.exit_code == 0) return {};
    if (!dataset.empty()) store::remove_left_behind(dataset);
    const bool known = end.exit_code >= 1 && end.exit_code <= 3;
    const std::string id = id_of(dataset);
    if (!known && !id.empty() && id != id_before)
        return {1, values.at("inputs").at(0) + ": the import was ended after the dataset was complete; it can be used",
                true};
    return {known ? end.exit_code : 1, describe_end(end, values, limits)};
}

} // namespace server::importing
