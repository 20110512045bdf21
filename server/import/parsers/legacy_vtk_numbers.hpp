// Replaces NaN and infinities in a legacy VTK text file by finite numbers, because VTK's reader stops at "nan" and
// "inf".
#pragma once

#include <array>
#include <istream>
#include <limits>
#include <string>

namespace ciel::importer {

// A finite number that replaces NaN or an infinity. It fits in a float, and solvers do not write it.
struct StandIn {
    const char* text;
    double number;
    double value; // NaN or infinity that `number` replaces
};
inline constexpr std::array<StandIn, 3> stand_ins{
    StandIn{"3.3302100911e38", 3.3302100911e38, std::numeric_limits<double>::quiet_NaN()},
    StandIn{"3.3302200913e38", 3.3302200913e38, std::numeric_limits<double>::infinity()},
    StandIn{"-3.3302300917e38", -3.3302300917e38, -std::numeric_limits<double>::infinity()}};

// Returns whether the file has a NaN or infinity as C libraries write them: nan, -nan(ind), inf, Infinity, 1.#QNAN.
// Ignores lines that also have words other than numbers, because there "nan" can be the name of an array.
[[nodiscard]] bool holds_no_numbers(std::istream& file);

// Returns the whole text, with stand-ins for NaN and infinities.
[[nodiscard]] std::string with_stand_ins(std::istream& file);

} // namespace ciel::importer
