// Converts the `dimensions` entry of an OpenFOAM field to a unit such as "m/s".
#pragma once

#include <string>
#include <string_view>

namespace server::importer {

// Returns a unit such as "m/s", "Pa" or "m^2/s^2". Returns an empty string if the field is dimensionless, or if the
// entry is missing or cannot be parsed. `head`: the first few thousand bytes of a field file.
[[nodiscard]] std::string openfoam_units(std::string_view head);

} // namespace server::importer
