// Replaces NaN and infinities in a legacy VTK text file by finite numbers, because VTK's reader stops at "nan" and
// "inf".
#pragma once

#include <array>
#include <istream>
#include <limits>
#include <string>

namespace ciel::importer {

// A finite number that replaces NaN or an infinity while VTK reads the file. The number fits in a float, and solvers do
// not write it.
struct StandIn {
    const char* text;
    double number;
    double value; // the NaN or infinity that `number` replaces
};
inline constexpr std::array<StandIn, 3> stand_ins{
    StandIn{"3.3302100911e38", 3.3302100911e38, std::numeric_limits<double>::quiet_NaN()},
    StandIn{"3.3302200913e38", 3.3302200913e38, std::numeric_limits<double>::infinity()},
    StandIn{"-3.3302300917e38", -3.3302300917e38, -std::numeric_limits<double>::infinity()}};

// Returns whether the file has NaN or an infinity in the spelling of C libraries: nan, -nan(ind), inf, Infinity,
// 1.#QNAN. Ignores a line with any other word that is not a number, because "nan" can be the name of an array there.
[[nodiscard]] bool holds_no_numbers(std::istream& file);

// Returns the text of the file, with NaN and infinities replaced by stand-ins.
[[nodiscard]] std::string with_stand_ins(std::istream& file);

} // namespace ciel::importer
