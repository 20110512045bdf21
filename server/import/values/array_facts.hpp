// Metadata of an array: the type of its numbers and the names of a tensor's components.
#pragma once

#include <string>
#include <vector>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>

namespace ciel::importer {

// Returns the type of the array's numbers, such as "float64" or "int32".
[[nodiscard]] std::string type_name(vtkDataArray* array);

// Returns whether a 32-bit float cannot hold all numbers of the array's type: float64, integers of 32 and 64 bits.
[[nodiscard]] bool needs_doubles(vtkDataArray* array);

// Returns "xx", "xy"... in file order for a tensor, else nothing. A tensor has six or nine components, and either such
// component names or VTK's attribute TENSORS.
[[nodiscard]] std::vector<std::string> tensor_component_names(vtkDataSetAttributes* attributes, vtkDataArray* array);

} // namespace ciel::importer
