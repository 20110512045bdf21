// Parses a field file of an OpenFOAM case, text or binary: values in the cells and on the patches (OpenFOAM User Guide,
// "Boundary conditions").
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace server::importer {

struct FoamValues {
    bool is_uniform = false;
    std::vector<double> numbers; // one tuple if is_uniform, else one tuple per cell or face
};

struct FoamCondition { // boundary condition of one patch, of a group, or of all patches that match a pattern
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

    // Returns the condition with the name of the patch. If there is none, returns the last condition with the name of
    // one of the groups, else the last condition whose pattern matches the name of the patch, else null.
    [[nodiscard]] const FoamCondition* condition(const std::string& patch,
                                                 const std::vector<std::string>& groups) const;
};

// Returns the number of components, for example 3 for volVectorField and 1 for volScalarField::Internal. Returns 0 if
// the class is no field.
[[nodiscard]] int foam_field_components(std::string_view class_name);

// `most`: number of cells; a longer list is refused. FoamCondition::value is nullopt if the file lists no values.
[[nodiscard]] FoamField parse_foam_field(std::string_view bytes, const std::string& file, std::size_t most);

} // namespace server::importer
