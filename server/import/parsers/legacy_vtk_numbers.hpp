// Replaces NaN and infinities in a legacy VTK text file, because VTK's reader stops at "nan" and "inf".
#pragma once

#include <array>
#include <istream>
#include <limits>
#include <string>

namespace server::importer {

// A finite number that VTK reads instead of NaN or infinity. It fits in a float, and solvers do not write it.
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

[[nodiscard]] std::string with_stand_ins(std::istream& file);

} // namespace server::importer
