// The options of an import. `ciel import` shows and forwards them, and ciel-import obeys them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace server::importing {

struct ImportOption {
    std::string_view name;  // the key in ImportValues
    std::string_view names; // names on the command line, such as "-o,--output"
    std::string_view value; // placeholder of the value in --help; empty: the option is a flag
    bool required;          // required options are positional
    bool several;
    std::string_view help;
};

inline constexpr ImportOption import_options[] = {
    {"inputs", "inputs", "INPUT...", true, true,
     "Files or OpenFOAM case directories. Several inputs are joined into one mesh. A dataset NAME.ciel of an earlier "
     "CIEL is converted to the current format. For PLOT3D, give the grid and its solutions; a grid alone also takes "
     "NAME.q from its directory."},
    {"output", "-o,--output", "NAME.ciel", false, false, "The dataset to write."},
    {"all", "--all", "", false, false,
     "Write all steps now. Otherwise, of more than two steps on one mesh, the first and the last one are written, and "
     "the others are read from the source when they are shown or extracted. With a dataset as the input: read all its "
     "missing steps from the source."},
    {"step", "--step", "N", false, true, "With a dataset as the input: read step N from its source; may be repeated."},
    {"late-folder", "--late-folder", "FOLDER", false, false,
     "Where steps of a dataset are written that cannot be written to the dataset itself."},
    {"list", "--list", "", false, false, "Print format, steps, blocks and arrays; convert nothing."},
    {"array", "-a,--array", "NAME", false, true, "Import this array only; may be repeated."},
    {"weld", "--weld", "", false, false,
     "Weld all points that coincide, also between blocks and across faults and baffles."},
    {"no-weld", "--no-weld", "", false, false,
     "Weld no points, not even the seam of a structured block that closes onto itself."},
    {"allow-bad", "--allow-bad", "", false, false,
     "Succeed even when steps, or more than 0.1 % of the cells, had to be left out."},
    {"force", "--force", "", false, false, "Replace an existing dataset of the same name."},
    {"plot3d", "--plot3d", "WORDS", false, false,
     "Layout of PLOT3D files whose size does not determine the layout, as words separated by commas: big, little, "
     "multi, single, records, stream, iblank, no-iblank, float32, float64, text."},
};

// If ciel-import fails, it prints one sentence with this prefix to standard error.
inline constexpr std::string_view import_error_prefix = "ciel-import: ";

// Exit code if an allocation failed. The caller then writes the error sentence, because only the caller knows the
// memory limit.
inline constexpr int import_out_of_memory = 4;

// Values by ImportOption::name. A flag on the command line has one value.
using ImportValues = std::map<std::string, std::vector<std::string>>;

} // namespace server::importing
