#include "vs_vtk/duel.hpp"

#include <algorithm>
#include <cstdio>

namespace ciel::vs_vtk {
using namespace server;

namespace {

constexpr std::size_t rounds = 5;
constexpr double long_run_seconds = 10; // a contender with a run longer than this is run once

struct Times {
    std::vector<double> wall, cpu;
    std::uint64_t counted = 0;
};

void run_once(const Contender& contender, Times& times) {
    if (contender.prepare) contender.prepare();
    const bench::Stopwatch watch;
    times.counted = contender.run();
    times.cpu.push_back(watch.cpu());
    times.wall.push_back(watch.wall());
}

double median(const std::vector<double>& times) { return bench::spread_of(times).median; }

void print(const std::string& name, const Times& times, const Times* ours) {
    const bench::Spread wall = bench::spread_of(times.wall), cpu = bench::spread_of(times.cpu);
    std::printf("    %-54s %10.2f  %9.2f..%-9.2f %10.2f %12llu", name.c_str(), 1e3 * wall.median, 1e3 * wall.low,
                1e3 * wall.high, 1e3 * cpu.median, static_cast<unsigned long long>(times.counted));
    if (ours != nullptr)
        std::printf("  %7.2fx %7.2fx", wall.median / bench::spread_of(ours->wall).median,
                    cpu.median / bench::spread_of(ours->cpu).median);
    std::printf("\n");
    std::fflush(stdout);
}

} // namespace

Outcome duel(const std::string& what, const Contender& ciel, const std::vector<Contender>& vtk) {
    std::printf("  %s\n    %-54s %10s  %9s..%-9s %10s %12s  %8s %8s\n", what.c_str(), "", "wall ms", "low", "high",
                "CPU ms", "counted", "by wall", "by CPU");
    Times ours;
    std::vector<Times> theirs(vtk.size());
    for (std::size_t round = 0; round <= rounds; ++round) {
        run_once(ciel, ours);
        for (std::size_t i = 0; i < vtk.size(); ++i)
            if (theirs[i].wall.empty() || theirs[i].wall.front() < long_run_seconds) run_once(vtk[i], theirs[i]);
        if (round > 0) continue;
        ours = {}; // discards the first round, which fills caches and buffers
        for (Times& times : theirs)
            if (times.wall.front() < long_run_seconds) times = {};
    }
    print(ciel.name, ours, nullptr);
    for (std::size_t i = 0; i < vtk.size(); ++i) print(vtk[i].name, theirs[i], &ours);
    const auto best = std::ranges::min_element(theirs, {}, [](const Times& times) { return median(times.wall); });
    return {median(ours.wall) / median(best->wall), median(ours.cpu) / median(best->cpu)};
}

} // namespace ciel::vs_vtk
