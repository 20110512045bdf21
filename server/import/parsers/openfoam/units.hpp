// The `dimensions` entry of an OpenFOAM field as units a reader knows: VTK's reader does not pass it on.
#pragma once

#include <string>
#include <string_view>

namespace ciel::importer {

// `head`: the first few thousand bytes of a field file. "m/s", "Pa", "m^2/s^2"; empty when the field is dimensionless
// or the entry is not there.
[[nodiscard]] std::string openfoam_units(std::string_view head);

} // namespace ciel::importer
