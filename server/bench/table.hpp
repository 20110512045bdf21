// Results of a benchmark (rows of times, and single figures), and functions that measure times.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace server::bench {

// Times in seconds. low and high are the quartiles, or the minimum and maximum of fewer than five runs.
struct Spread {
    double median = 0, low = 0, high = 0;
};

struct Row {
    std::string what;
    Spread wall, cpu; // cpu: CPU time of all threads of the process
    std::uint64_t repetitions = 0;
    std::uint64_t triangles = 0; // triangles of one repetition; 0 if it makes none
    std::string note;
};

class Stopwatch {
public:
    Stopwatch();
    [[nodiscard]] double wall() const;
    [[nodiscard]] double cpu() const;

private:
    double wall_, cpu_;
};

[[nodiscard]] Spread spread_of(std::vector<double> times); // REQUIRES: `times` is not empty

struct Figure {
    std::string what;
    double value = 0;
    std::string unit;
};

struct Table {
    std::string name; // such as "surfaces"
    std::vector<Figure> figures;
    std::vector<Row> rows;
};

// Measures runs of `body`, which returns the number of triangles that it made. `prepare` runs before each run and is
// not measured. The first run fills caches and is not counted, unless it takes 1 s: then it is the only run. Then
// `body` runs until 0.25 s are measured, but at least 3 and at most 25 times. A counted run of more than 0.5 s is the
// last run.
[[nodiscard]] Row measure(const std::string& what, const std::function<std::uint64_t()>& body,
                          const std::function<void()>& prepare = {});

} // namespace server::bench
