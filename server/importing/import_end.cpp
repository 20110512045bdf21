#include "importing/import_end.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <iomanip>
#include <sstream>

namespace server::importing {
namespace {

std::string number(double value) {
    std::ostringstream text;
    if (value >= 999.5) // three digits would become 1e+03
        text << std::fixed << std::setprecision(0) << value;
    else
        text << std::setprecision(3) << value;
    return text.str();
}

struct Words {
    std::string own;   // the last error sentence of ciel-import
    std::string other; // the last line printed by a library, the dynamic loader or the C++ runtime
};

Words last_words(const std::string& errors) {
    Words words;
    std::istringstream lines(errors);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(import_error_prefix))
            words.own = line.substr(import_error_prefix.size());
        else if (!line.empty())
            words.other = line;
    }
    return words;
}

// Returns whether the exit code, or a message of the dynamic loader or the C++ runtime, shows that memory ran out.
bool ran_out_of_memory(const processes::ChildEnd& end, const Words& last) {
    if (end.exit_code == import_out_of_memory) return true;
    if (!last.own.empty()) return false;
    constexpr std::array words{"failed to map segment",
                               "cannot map zero-fill pages",
                               "annot allocate memory",
                               "std::bad_alloc",
                               "cannot create shared object descriptor",
                               "out of memory"};
    return std::any_of(words.begin(), words.end(),
                       [&](const char* word) { return end.errors.find(word) != std::string::npos; });
}

std::string describe_memory(const std::string& input, const ImportLimits& limits, const std::string& outcome) {
    if (limits.memory_gigabytes <= 0)
        return input +
               ": the import needs more memory than the machine has, or the file is damaged and declares more data "
               "than it holds" +
               outcome;
    return input + ": the memory limit of " + number(limits.memory_gigabytes) +
           " GB was reached; raise the limit with " + limits.memory_option +
           ", unless the file is damaged and declares more data than it holds" + outcome;
}

std::string describe_signal(int signal, const std::string& input, const ImportLimits& limits,
                            const std::string& outcome) {
    if (signal == SIGKILL)
        return input +
               ": the import was killed from outside, most likely because the machine ran out of memory, and the file "
               "may be sound. Free some memory, or set a lower " +
               limits.memory_option + " to get an error instead" + outcome;
    if (signal == SIGBUS)
        return input +
               ": a file became shorter while the import used it, or a disk failed. Check both disks, that of the "
               "input and that of the output, and import it again" +
               outcome;
    std::string sentence = input + ": the reader crashed (" + ::strsignal(signal) + "): the file is damaged";
    if (limits.memory_gigabytes > 0)
        sentence +=
            ", or the import needs more than the " + number(limits.memory_gigabytes) + " GB of " + limits.memory_option;
    return sentence + outcome;
}

} // namespace

std::string describe_end(const processes::ChildEnd& end, const ImportValues& values, const ImportLimits& limits) {
    const auto is_given = [&](const char* option) { return values.contains(option) && !values.at(option).empty(); };
    const bool reads_late_steps = is_given("all") || is_given("step");
    const std::string outcome = reads_late_steps ? "; steps that were read before are kept" : "; nothing was written";
    const std::string input = (reads_late_steps ? "the source of " : "") + values.at("inputs").at(0);
    if (end.cancelled) return "the import was cancelled" + outcome;
    if (end.timed_out)
        return input + ": the import took longer than " + number(limits.seconds) +
               " s and was stopped; raise --time-limit (0: none)" + outcome;
    if (end.stalled)
        return input + ": the import made no progress for " + number(limits.stalled_seconds) +
               " s and was stopped: the file is damaged, or the import needs a longer " + limits.stalled_option +
               outcome;
    const Words last = last_words(end.errors);
    if (ran_out_of_memory(end, last)) return describe_memory(input, limits, outcome);
    if (end.signal != 0) return describe_signal(end.signal, input, limits, outcome);
    if (!last.own.empty()) return last.own;
    if (!last.other.empty()) return input + ": the reader failed: " + last.other;
    return input + ": ciel-import ended with exit code " + std::to_string(end.exit_code) + " and printed no reason";
}

} // namespace server::importing
