#include "store/importer.hpp"

#include "ciel/types.hpp"
#include "store/child_process.hpp"
#include "store/place.hpp"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <unistd.h>

namespace ciel::store {
namespace {

namespace fs = std::filesystem;
constexpr const char* program = "ciel-import";
constexpr double gigabyte = 1e9;
constexpr std::uint64_t least_memory = 64ULL << 20; // less and not even the program's libraries load

std::uint64_t memory_limit(double gigabytes) {
    if (gigabytes > 0) return std::max(static_cast<std::uint64_t>(gigabytes * gigabyte), least_memory);
    return static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

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
    arguments.emplace_back("--"); // an input may begin with a dash
    arguments.insert(arguments.end(), positional.begin(), positional.end());
    return arguments;
}

// The importer's own sentence; without one (a library ended the process), the last that anybody said.
std::string last_words(const std::string& errors, const std::string& input) {
    std::string own;
    std::string other;
    std::istringstream lines(errors);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(import_error_prefix))
            own = line.substr(import_error_prefix.size());
        else if (!line.empty())
            other = line;
    }
    return own.empty() && !other.empty() ? input + ": the reader gave up: " + other : own;
}

std::string number(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

std::string describe(const ChildEnd& end, const std::string& input, const ImportLimits& limits, double memory) {
    if (end.cancelled) return "the import was cancelled; nothing was written";
    if (end.timed_out)
        return input + ": the import took longer than " + number(limits.seconds) +
               " s and was stopped (--time-limit); nothing was written";
    if (end.signal != 0)
        return input + ": the reader crashed (" + ::strsignal(end.signal) +
               "): the file is damaged, or needs more than " + number(memory / gigabyte) +
               " GB (--memory-limit); nothing was written";
    if (std::string words = last_words(end.errors, input); !words.empty()) return words;
    return input + ": ciel-import ended with code " + std::to_string(end.exit_code) + " and no reason";
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

} // namespace

fs::path find_import_program() {
    std::error_code error;
    fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path() / program;
    if (::access(beside.c_str(), X_OK) == 0) return beside;
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (fs::path found = fs::path(folder) / program; ::access(found.c_str(), X_OK) == 0) return found;
    throw Error("ciel-import was not found beside ciel or on PATH; it is built with -DCIEL_IMPORT=ON and needs VTK 9");
}

ImportEnd run_import(const ImportValues& values, const ImportLimits& limits, const ImportListener& listener,
                     const std::atomic<bool>& cancel) {
    const std::uint64_t memory = memory_limit(limits.memory_gigabytes);
    const ChildEnd end = run_child(
        command_line(values), {memory, limits.seconds}, [&](std::string_view line) { pass_line(line, listener); },
        cancel);
    if (end.exit_code == 0) return {};
    if (const auto output = values.find("output"); output != values.end() && !output->second.empty())
        remove_left_behind(output->second.back());
    const std::string input = values.at("inputs").at(0);
    const bool known = end.exit_code >= 1 && end.exit_code <= 3;
    return {known ? end.exit_code : 1, describe(end, input, limits, static_cast<double>(memory))};
}

} // namespace ciel::store
