// A field file of an OpenFOAM case, as text or binary: its values in the cells and on the patches (OpenFOAM User Guide,
// "Boundary conditions").
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::importer {

struct FoamValues {
    bool is_uniform = false;
    std::vector<double> numbers; // one tuple where it is uniform
};

struct FoamCondition { // on one patch, on a group of patches, or on all whose names match
    std::string name;
    bool is_pattern = false; // `name` is a regular expression
    std::string type;        // "fixedValue"; empty where the file does not say
    std::optional<FoamValues> value;
};

struct FoamField {
    int components = 1;
    bool is_single_precision = false; // binary, with scalars of 32 bits
    FoamValues cells;
    std::vector<FoamCondition> conditions;

    // By the patch's name, else by one of its groups, else by the last pattern that matches.
    [[nodiscard]] const FoamCondition* condition(const std::string& patch,
                                                 const std::vector<std::string>& groups) const;
};

// Numbers per cell of a class such as volVectorField or volScalarField::Internal; 0 for other classes.
[[nodiscard]] int foam_field_components(std::string_view class_name);

// `most`: how many cells there are. Throws Error naming `file`. A condition's value that is not written out is nullopt.
[[nodiscard]] FoamField parse_foam_field(std::string_view bytes, const std::string& file, std::size_t most);

} // namespace ciel::importer
