#include "import/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace ciel::importer {

namespace {

constexpr const char* bookkeeping[] = {"vtkGhostType",   "vtkOriginalPointIds", "vtkOriginalCellIds",
                                       "IBlank",         "GlobalNodeId",        "GlobalElementId",
                                       "PedigreeNodeId", "PedigreeElementId",   "ObjectId",
                                       "vtkBlockColors", "vtkCompositeIndex",   "vtkValidPointMask"};

vtkDataSetAttributes* attributes(vtkDataSet* data, FieldOf of) {
    if (of == FieldOf::points) return data->GetPointData();
    return data->GetCellData();
}

void collect(const JoinedMesh::Part& part, FieldOf of, std::map<std::string, std::vector<FieldName>>& found) {
    vtkDataSetAttributes* data = attributes(part.data, of);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
        vtkDataArray* array = data->GetArray(i); // null for text
        if (array == nullptr || array->GetName() == nullptr || *array->GetName() == '\0') continue;
        const std::string name = array->GetName();
        const bool skip = std::find(std::begin(bookkeeping), std::end(bookkeeping), name) != std::end(bookkeeping);
        if (!skip) found[name].push_back({{of, name}, array->GetNumberOfComponents()});
    }
}

} // namespace

std::vector<FieldName> field_names(const std::vector<JoinedMesh::Part>& parts) {
    std::vector<FieldName> names;
    for (const FieldOf of : {FieldOf::points, FieldOf::cells}) {
        std::map<std::string, std::vector<FieldName>> found;
        for (const JoinedMesh::Part& part : parts) collect(part, of, found);
        for (const auto& [name, fields] : found) {
            const int components = fields.front().components;
            if (std::all_of(fields.begin(), fields.end(),
                            [components](const FieldName& field) { return field.components == components; }))
                names.push_back(fields.front());
        }
    }
    return names;
}

std::vector<FieldName> field_names(const Blocks& blocks) {
    std::vector<JoinedMesh::Part> parts;
    for (const Block& block : blocks.volumes) parts.push_back({block.name, block.data, 0, 0, 0, 0});
    return field_names(parts);
}

std::vector<float> array_values(vtkDataSet* data, const FieldName& field) {
    vtkDataArray* array = attributes(data, field.of)->GetArray(field.name.c_str());
    if (array == nullptr || array->GetNumberOfComponents() != field.components) return {};
    vtkNew<vtkFloatArray> floats;
    floats->DeepCopy(array); // converts
    const float* begin = floats->GetPointer(0);
    return {begin, begin + floats->GetNumberOfValues()};
}

std::vector<float> gather_field(const std::vector<JoinedMesh::Part>& parts, const FieldName& field) {
    const bool points = field.of == FieldOf::points;
    const auto size_of = [&](const JoinedMesh::Part& part) {
        return static_cast<std::size_t>(points ? part.data->GetNumberOfPoints() : part.data->GetNumberOfCells());
    };
    const auto first_of = [&](const JoinedMesh::Part& part) {
        return std::size_t{points ? part.first_point : part.first_cell};
    };
    std::size_t count = 0;
    for (const JoinedMesh::Part& part : parts) count = std::max(count, first_of(part) + size_of(part));

    const auto components = static_cast<std::size_t>(field.components);
    std::vector<float> values(count * components, std::numeric_limits<float>::quiet_NaN());
    for (const JoinedMesh::Part& part : parts) {
        const std::vector<float> own = array_values(part.data, field);
        if (own.empty()) continue;
        if (own.size() != size_of(part) * components)
            throw Error("array \"" + field.name + "\" of block \"" + part.name + "\" has " +
                        std::to_string(own.size() / components) + " values where " + std::to_string(size_of(part)) +
                        " are needed");
        std::copy(own.begin(), own.end(), values.begin() + static_cast<std::ptrdiff_t>(first_of(part) * components));
    }
    return values;
}

} // namespace ciel::importer
