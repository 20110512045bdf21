// The values of a step, array by array, in running order (joined_mesh.hpp).
#pragma once

#include "import/mesh/joined_mesh.hpp"
#include "import/source/array_selection.hpp"
#include "import/source/data_sets.hpp"

namespace ciel::importer {

struct FieldName : ArrayName {
    int components = 1;
    std::vector<std::string> component_names{}; // of a tensor (array_facts.hpp)
    std::string type{};                         // of the numbers in the file
};

// What the blocks offer, sorted by name. Ghost levels, ids and blanking are bookkeeping, not fields; arrays whose
// components differ between blocks, and those of text, are left out.
[[nodiscard]] std::vector<FieldName> field_names(const std::vector<JoinedMesh::Member>& parts);
[[nodiscard]] std::vector<FieldName> field_names(const DataSets& data_sets); // of the volumes

// Sentences on what the blocks have and field_names leaves out.
[[nodiscard]] std::vector<std::string> left_out_arrays(const std::vector<JoinedMesh::Member>& parts);
// The same on arrays that should be in the dataset.
[[nodiscard]] std::vector<std::string> lost_arrays(const std::vector<JoinedMesh::Member>& parts);

// components values per running point or cell. Blocks that lack the array give store::no_value.
[[nodiscard]] std::vector<float> gather_field(const std::vector<JoinedMesh::Member>& parts, const FieldName& field);

// "3 components", "6 components (xx, xy, xz, yy, yz, zz)": what has to be the same wherever an array is.
[[nodiscard]] std::string components_text(const FieldName& field);

// The same for one array of one data set, as floats; a tensor's components in the order of `field`.
[[nodiscard]] std::vector<float> array_values(vtkDataSet* data, const FieldName& field);

} // namespace ciel::importer
