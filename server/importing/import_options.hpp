// The options of an import, declared once: `ciel import` shows and forwards them, ciel-import obeys them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::importing {

struct ImportOption {
    std::string_view name;  // the key in ImportValues
    std::string_view names; // as on the command line
    std::string_view value; // name of its value; empty: a flag
    bool required;          // positional
    bool several;
    std::string_view help;
};

inline constexpr ImportOption import_options[] = {
    {"inputs", "inputs", "INPUT...", true, true,
     "Files or OpenFOAM case directories. Several are parts of one mesh; for PLOT3D the grid and its solutions (a grid "
     "alone takes NAME.q beside it along)."},
    {"output", "-o,--output", "NAME.ciel", false, false, "The dataset to write."},
    {"list", "--list", "", false, false, "Print format, steps, blocks and arrays; convert nothing."},
    {"array", "-a,--array", "NAME", false, true, "Import this array only; may be repeated."},
    {"weld", "--weld", "", false, false,
     "Make one of all points that coincide, also between blocks, faults and baffles."},
    {"no-weld", "--no-weld", "", false, false,
     "Weld nothing, not even the seam of a structured block closed onto itself."},
    {"allow-bad", "--allow-bad", "", false, false,
     "Succeed even when steps, or more than 0.1 % of the cells, had to be left out."},
    {"force", "--force", "", false, false, "Replace the dataset when it exists."},
    {"plot3d", "--plot3d", "WORDS", false, false,
     "How PLOT3D files are laid out where that cannot be told from their size, separated by commas: big, little, "
     "multi, single, records, stream, iblank, no-iblank, float32, float64, text."},
};

// Prefix of the sentence on standard error with which ciel-import ends when it fails.
inline constexpr std::string_view import_error_prefix = "ciel-import: ";

// Exit code of ciel-import when an allocation failed; the caller adds the memory limit to the message.
inline constexpr int import_out_of_memory = 4;

using ImportValues = std::map<std::string, std::vector<std::string>>; // by name; a given flag has one value

} // namespace ciel::importing
