#include "import/values/array_facts.hpp"

#include <algorithm>
#include <cctype>
#include <set>

namespace server::importer {

namespace {

bool is_axis(char c) { return c == 'x' || c == 'y' || c == 'z'; }

std::vector<std::string> given_names(vtkDataArray* array) {
    std::vector<std::string> names;
    for (int c = 0; c < array->GetNumberOfComponents(); ++c) {
        const char* given = array->GetComponentName(c);
        std::string name = given == nullptr ? "" : given;
        std::transform(name.begin(), name.end(), name.begin(), [](unsigned char l) { return std::tolower(l); });
        if (name.size() != 2 || !is_axis(name[0]) || !is_axis(name[1])) return {};
        names.push_back(std::move(name));
    }
    if (std::set<std::string>(names.begin(), names.end()).size() != names.size()) return {};
    return names;
}

} // namespace

std::string type_name(vtkDataArray* array) {
    const std::string bits = std::to_string(8 * array->GetDataTypeSize());
    switch (array->GetDataType()) {
    case VTK_FLOAT:
    case VTK_DOUBLE:
        return "float" + bits;
    case VTK_UNSIGNED_CHAR:
    case VTK_UNSIGNED_SHORT:
    case VTK_UNSIGNED_INT:
    case VTK_UNSIGNED_LONG:
    case VTK_UNSIGNED_LONG_LONG:
        return "uint" + bits;
    default:
        return "int" + bits;
    }
}

bool needs_doubles(vtkDataArray* array) { return array->GetDataTypeSize() >= 4 && array->GetDataType() != VTK_FLOAT; }

std::vector<std::string> tensor_component_names(vtkDataSetAttributes* attributes, vtkDataArray* array) {
    const int components = array->GetNumberOfComponents();
    if (components != 6 && components != 9) return {};
    if (array->HasAComponentName())
        if (std::vector<std::string> names = given_names(array); !names.empty()) return names;
    if (attributes->GetTensors() != array) return {};
    if (components == 6) return {"xx", "yy", "zz", "xy", "yz", "xz"}; // VTK's order for symmetric tensors
    return {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
}

} // namespace server::importer
