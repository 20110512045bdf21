// The values of an ascii legacy VTK file that are no numbers. VTK's reader stops at "nan" and "inf", so they go through
// it as numbers that stand for them.
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

// Whether an ascii file holds "nan" or "inf" anywhere, in a name perhaps.
[[nodiscard]] bool may_hold_no_numbers(std::istream& file);

// The text with stand-ins. Lines that hold a word that is no number are left alone: they name arrays.
[[nodiscard]] std::string with_stand_ins(const std::string& text);

} // namespace ciel::importer
