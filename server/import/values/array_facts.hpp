// What a file says of an array besides its values: the type of its numbers, the names of a tensor's components.
#pragma once

#include <string>
#include <vector>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>

namespace ciel::importer {

// "float64", "int32".
[[nodiscard]] std::string type_name(vtkDataArray* array);

// "xx", "xy"... in the order of the file, where it says that an array of six or nine components is a tensor: by their
// names, or as one of VTK's attributes. Else empty.
[[nodiscard]] std::vector<std::string> tensor_component_names(vtkDataSetAttributes* attributes, vtkDataArray* array);

} // namespace ciel::importer
