// What a bench has measured: rows of times, and rows of plain figures.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ciel::bench {

// Seconds. Quartiles tell the spread; of few repetitions they are the ends.
struct Spread {
    double median = 0, low = 0, high = 0;
};

struct Row {
    std::string what;
    Spread wall, cpu; // cpu: of all threads of the process
    std::uint64_t repetitions = 0;
    std::uint64_t triangles = 0; // of one repetition; 0 where there are none
    std::string note;            // what else is worth telling
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

[[nodiscard]] Spread spread_of(std::vector<double> times); // one at least

struct Figure {
    std::string what;
    double value = 0;
    std::string unit;
};

struct Table {
    std::string name; // "surfaces", as the paper's tables
    std::vector<Figure> figures;
    std::vector<Row> rows;
};

// Runs `body` until a quarter of a second of work is measured, 3 times at least and 25 at most, after one run that is
// not counted (it fills caches and buffers); what takes more than half a second is measured once. After a first run of
// more than three seconds there is no other: it is the one that counts, and the row's note says so. `prepare` runs
// before each, untimed. The body returns its triangles.
[[nodiscard]] Row measure(const std::string& what, const std::function<std::uint64_t()>& body,
                          const std::function<void()>& prepare = {});

} // namespace ciel::bench
