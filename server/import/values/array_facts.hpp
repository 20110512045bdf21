// Metadata of an array: the type of its numbers and the names of a tensor's components.
#pragma once

#include <string>
#include <vector>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>

namespace ciel::importer {

// Returns the type of the array's numbers, such as "float64" or "int32".
[[nodiscard]] std::string type_name(vtkDataArray* array);

// Returns whether 32-bit floats cannot hold all numbers of the array's type. True for float64, and for integers of 32
// and 64 bits.
[[nodiscard]] bool needs_doubles(vtkDataArray* array);

// For a tensor, returns the names of the components ("xx", "xy"...) in file order. For other arrays, returns an empty
// list. A tensor has six or nine components. In addition, the components have such names, or the array is VTK's
// attribute TENSORS.
[[nodiscard]] std::vector<std::string> tensor_component_names(vtkDataSetAttributes* attributes, vtkDataArray* array);

} // namespace ciel::importer
