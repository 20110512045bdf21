#include "bench/table.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace server::bench {

namespace {

constexpr double enough_seconds = 0.25;
constexpr double long_seconds = 0.5, too_long_seconds = 1;
constexpr std::size_t least = 3, most = 25;

double wall_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double cpu_now() {
    std::timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

Stopwatch::Stopwatch() : wall_(wall_now()), cpu_(cpu_now()) {}
double Stopwatch::wall() const { return wall_now() - wall_; }
double Stopwatch::cpu() const { return cpu_now() - cpu_; }

Spread spread_of(std::vector<double> times) {
    std::ranges::sort(times);
    const std::size_t last = times.size() - 1;
    return {times[last / 2], times[last / 4], times[last - last / 4]};
}

Row measure(const std::string& what, const std::function<std::uint64_t()>& body, const std::function<void()>& prepare) {
    Row row;
    row.what = what;
    std::vector<double> wall, cpu;
    double measured = 0;
    for (std::size_t run = 0; run <= least || (run <= most && measured < enough_seconds); ++run) {
        if (prepare) prepare();
        const Stopwatch watch;
        row.triangles = body();
        if (run == 0 && watch.wall() < too_long_seconds) continue;
        cpu.push_back(watch.cpu());
        wall.push_back(watch.wall());
        measured += wall.back();
        if (run == 0) row.note = "one run, its first";
        if (wall.back() > long_seconds) break;
    }
    row.wall = spread_of(wall);
    row.cpu = spread_of(cpu);
    row.repetitions = wall.size();
    return row;
}

} // namespace server::bench
