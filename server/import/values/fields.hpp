// The values of a step, array by array, in running order (joined_mesh.hpp).
#pragma once

#include "import/mesh/joined_mesh.hpp"
#include "import/source/array_selection.hpp"
#include "import/source/data_sets.hpp"
#include "store/format/values.hpp"

namespace ciel::importer {

struct FieldName : ArrayName {
    int components = 1;
    std::vector<std::string> component_names{}; // tensor_component_names() of the array
    std::string type{};                         // type_name() of the array, such as "float64"
    bool doubles = false;                       // type of the values below: needs_doubles() of the array in any part
};

// Returns the point arrays of all blocks, then the cell arrays, each sorted by name. Leaves out ghost flags, ids,
// blanking, text, and arrays whose components differ between blocks.
[[nodiscard]] std::vector<FieldName> field_names(const std::vector<JoinedMesh::Member>& parts);
[[nodiscard]] std::vector<FieldName> field_names(const DataSets& data_sets); // of data_sets.volumes

// Returns sentences on flags, ids, text, field data and unnamed arrays, which are left out.
[[nodiscard]] std::vector<std::string> left_out_arrays(const std::vector<JoinedMesh::Member>& parts);
// Returns a sentence on arrays that are left out because their components differ between blocks.
[[nodiscard]] std::vector<std::string> lost_arrays(const std::vector<JoinedMesh::Member>& parts);

// Returns field.components values per running point or cell; store::no_value in blocks without the array. Throws Error
// if a block's array has a wrong size.
[[nodiscard]] store::Values gather_field(const std::vector<JoinedMesh::Member>& parts, const FieldName& field);

// Returns text such as "3 components" or "6 components (xx, xy, xz, yy, yz, zz)". It must be the same for an array in
// all blocks and at all steps.
[[nodiscard]] std::string components_text(const FieldName& field);

// Returns the values of one array of one data set, a tensor's components in the order of `field`. Empty if the array is
// missing or has another number of components.
[[nodiscard]] store::Values array_values(vtkDataSet* data, const FieldName& field);

} // namespace ciel::importer
