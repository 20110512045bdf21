// Results of a benchmark: rows of times and rows of figures.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ciel::bench {

// Seconds. low and high are quartiles; of fewer than five repetitions, the minimum and maximum.
struct Spread {
    double median = 0, low = 0, high = 0;
};

struct Row {
    std::string what;
    Spread wall, cpu; // cpu: of all threads of the process
    std::uint64_t repetitions = 0;
    std::uint64_t triangles = 0; // of one repetition; 0 where there are none
    std::string note;            // free text
};

// Wall and CPU seconds since it was made.
class Stopwatch {
public:
    Stopwatch();
    [[nodiscard]] double wall() const;
    [[nodiscard]] double cpu() const;

private:
    double wall_, cpu_;
};

[[nodiscard]] Spread spread_of(std::vector<double> times); // at least one time

struct Figure {
    std::string what;
    double value = 0;
    std::string unit;
};

struct Table {
    std::string name; // e.g. "surfaces", after the paper's tables
    std::vector<Figure> figures;
    std::vector<Row> rows;
};

// Runs `body` until 0.25 s are measured: at least 3 and at most 25 times. The first run fills caches and is not
// counted. After a counted run of more than 0.5 s there is no other. A first run of at least 1 s is the only one: it
// counts, and the row's note says so. `prepare` runs before each run, untimed. `body` returns its number of triangles.
[[nodiscard]] Row measure(const std::string& what, const std::function<std::uint64_t()>& body,
                          const std::function<void()>& prepare = {});

} // namespace ciel::bench
