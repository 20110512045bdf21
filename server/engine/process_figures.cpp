#include "engine/process_figures.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

namespace server::engine {
namespace {

// Returns the fields from the third on (proc_pid_stat(5)). The second, a name in parentheses, may contain blanks.
std::vector<std::string> stat_fields() {
    std::ifstream file("/proc/self/stat");
    std::string line;
    std::getline(file, line);
    std::istringstream rest(line.substr(std::min(line.rfind(')') + 1, line.size())));
    return {std::istream_iterator<std::string>(rest), {}};
}

std::optional<double> field(const std::vector<std::string>& fields, std::size_t number) {
    const std::size_t index = number - 3;
    if (index >= fields.size()) return {};
    return std::stod(fields[index]);
}

std::optional<double> boot_time() {
    std::ifstream file("/proc/stat");
    std::string name;
    for (double value = 0; file >> name; file.ignore(1 << 16, '\n'))
        if (name == "btime" && file >> value) return value;
    return {};
}

std::optional<double> open_files() {
    std::error_code failure;
    std::filesystem::directory_iterator entries("/proc/self/fd", failure);
    if (failure) return {};
    return static_cast<double>(std::distance(begin(entries), end(entries)) - 1); // without the iterator's descriptor
}

std::optional<double> limit_of(__rlimit_resource resource) {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
    return static_cast<double>(limit.rlim_cur);
}

void write(std::ostream& out, const char* name, const char* type, const char* help, std::optional<double> value) {
    if (!value) return;
    out << "# HELP " << name << ' ' << help << "\n# TYPE " << name << ' ' << type << '\n'
        << name << ' ' << *value << '\n';
}

std::optional<double> scaled(std::optional<double> value, double by) {
    return value ? std::optional(*value * by) : std::nullopt;
}

} // namespace

void write_process_figures(std::ostream& out) {
    constexpr std::size_t user_time = 14, system_time = 15, start_time = 22, virtual_bytes = 23, resident_pages = 24,
                          threads = 20;
    const auto fields = stat_fields();
    const double tick = 1.0 / static_cast<double>(sysconf(_SC_CLK_TCK));
    const auto user = field(fields, user_time), system = field(fields, system_time), boot = boot_time(),
               start = field(fields, start_time);
    write(out, "process_cpu_seconds_total", "counter", "Total user and system CPU time spent in seconds.",
          user && system ? scaled(*user + *system, tick) : std::nullopt);
    write(out, "process_open_fds", "gauge", "Number of open file descriptors.", open_files());
    write(out, "process_max_fds", "gauge", "Maximum number of open file descriptors.", limit_of(RLIMIT_NOFILE));
    write(out, "process_virtual_memory_bytes", "gauge", "Virtual memory size in bytes.", field(fields, virtual_bytes));
    write(out, "process_virtual_memory_max_bytes", "gauge", "Maximum amount of virtual memory available in bytes.",
          limit_of(RLIMIT_AS));
    write(out, "process_resident_memory_bytes", "gauge", "Resident memory size in bytes.",
          scaled(field(fields, resident_pages), static_cast<double>(sysconf(_SC_PAGESIZE))));
    write(out, "process_start_time_seconds", "gauge", "Start time of the process since unix epoch in seconds.",
          boot && start ? std::optional(*boot + *start * tick) : std::nullopt);
    write(out, "process_threads", "gauge", "Number of OS threads in the process.", field(fields, threads));
}

} // namespace server::engine
