// Parses a field file of an OpenFOAM case, text or binary: values in the cells and on the patches (OpenFOAM User Guide,
// "Boundary conditions").
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::importer {

struct FoamValues {
    bool is_uniform = false;
    std::vector<double> numbers; // one tuple if uniform, else one per cell or face
};

struct FoamCondition { // of one patch, of a group of patches, or of all patches whose names match
    std::string name;
    bool is_pattern = false; // `name` is a regular expression
    std::string type;        // such as "fixedValue"; empty if the file gives none
    std::optional<FoamValues> value;
};

struct FoamField {
    int components = 1;
    bool is_single_precision = false; // the file is binary with 32-bit scalars
    FoamValues cells;
    std::vector<FoamCondition> conditions;

    // Returns the condition with the patch's name, else that of one of its groups, else the last one whose pattern
    // matches the patch's name; null if there is none.
    [[nodiscard]] const FoamCondition* condition(const std::string& patch,
                                                 const std::vector<std::string>& groups) const;
};

// Returns the number of components of a class such as volVectorField or volScalarField::Internal; 0 for other classes.
[[nodiscard]] int foam_field_components(std::string_view class_name);

// `most`: the number of cells; longer lists are refused. The value of a condition is nullopt unless the file lists it.
// Throws Error naming `file`.
[[nodiscard]] FoamField parse_foam_field(std::string_view bytes, const std::string& file, std::size_t most);

} // namespace ciel::importer
