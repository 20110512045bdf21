// The values of a legacy VTK file of text that are no numbers. VTK's reader stops at "nan" and "inf", so they go
// through it as numbers that stand for them.
#pragma once

#include <array>
#include <istream>
#include <limits>
#include <string>

namespace ciel::importer {

// What stands for NaN, infinity and minus infinity: floats, and nothing that a solver writes.
struct StandIn {
    const char* text;
    double number;
    double value; // that it stands for
};
inline constexpr std::array<StandIn, 3> stand_ins{
    StandIn{"3.3302100911e38", 3.3302100911e38, std::numeric_limits<double>::quiet_NaN()},
    StandIn{"3.3302200913e38", 3.3302200913e38, std::numeric_limits<double>::infinity()},
    StandIn{"-3.3302300917e38", -3.3302300917e38, -std::numeric_limits<double>::infinity()}};

// Whether there is a value that is no number, as C libraries write those: nan, -nan(ind), inf, Infinity, 1.#QNAN. Lines
// that hold any other word name arrays.
[[nodiscard]] bool holds_no_numbers(std::istream& file);

// The whole text, with stand-ins for these values.
[[nodiscard]] std::string with_stand_ins(std::istream& file);

} // namespace ciel::importer
