// Reads the arrays of a step from the members of the mesh. The values are in the order of running ids
// (joined_mesh.hpp).
#pragma once

#include "import/mesh/joined_mesh.hpp"
#include "import/source/array_selection.hpp"
#include "import/source/input_grids.hpp"
#include "store/format/values.hpp"

namespace server::importer {

struct FieldName : ArrayName {
    int components = 1;
    std::vector<std::string> component_names{}; // tensor_component_names() of the array
    std::string type{};                         // type_name() of the array, such as "float64"
    bool doubles = false; // true: values are float64, because needs_doubles() is true in at least one member
};

// Returns the point arrays of all members, then the cell arrays. Both groups are sorted by name. Leaves out ghost
// flags, ids, blanking, text, and arrays whose components differ between members.
[[nodiscard]] std::vector<FieldName> field_names(const std::vector<JoinedMesh::Member>& members);
[[nodiscard]] std::vector<FieldName> field_names(const InputGrids& input_grids); // arrays of input_grids.volumes

// Returns sentences on the arrays that are left out: flags, ids, text, field data, and arrays without a name.
[[nodiscard]] std::vector<std::string> left_out_arrays(const std::vector<JoinedMesh::Member>& members);
// Returns a sentence on arrays that are left out because their components differ between members.
[[nodiscard]] std::vector<std::string> lost_arrays(const std::vector<JoinedMesh::Member>& members);

// Members without the array get store::no_value. Throws Error if the array of a member has a wrong size.
[[nodiscard]] store::Values gather_field(const std::vector<JoinedMesh::Member>& members, const FieldName& field);

// Returns a text such as "6 components (xx, xy, xz, yy, yz, zz)". Equal texts mean equal components.
[[nodiscard]] std::string components_text(const FieldName& field);

// Returns the values of the array in `data`, with tensor components in the order of field.component_names. Returns no
// values if the array does not fit `field`.
[[nodiscard]] store::Values array_values(vtkDataSet* data, const FieldName& field);

} // namespace server::importer
