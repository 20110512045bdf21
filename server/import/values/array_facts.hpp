// Metadata of an array: the type of its numbers and the names of a tensor's components.
#pragma once

#include <string>
#include <vector>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>

namespace server::importer {

// Returns a type such as "float64" or "int32".
[[nodiscard]] std::string type_name(vtkDataArray* array);

// True for float64 and for integers of 32 and 64 bits, because 32-bit floats cannot hold all their numbers.
[[nodiscard]] bool needs_doubles(vtkDataArray* array);

// Returns the names of a tensor's components ("xx", "xy"...) in file order; empty for other arrays. An array of six or
// nine components is a tensor if it has such names, or if it is VTK's attribute TENSORS.
[[nodiscard]] std::vector<std::string> tensor_component_names(vtkDataSetAttributes* attributes, vtkDataArray* array);

} // namespace server::importer
