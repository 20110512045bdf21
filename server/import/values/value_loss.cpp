#include "import/values/value_loss.hpp"

#include <cmath>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

namespace ciel::importer {

void ValueLoss::look_at(const std::vector<JoinedMesh::Member>& parts, const FieldName& field) {
    Count& count = counts_[(field.of == FieldOf::cells ? "cell:" : "") + field.name];
    for (const JoinedMesh::Member& part : parts) {
        vtkDataSetAttributes* data = part.data->GetPointData();
        if (field.of == FieldOf::cells) data = part.data->GetCellData();
        vtkDataArray* array = data->GetArray(field.name.c_str());
        if (array == nullptr || array->GetDataType() == VTK_FLOAT) continue;
        const bool is_real = array->GetDataType() == VTK_DOUBLE;
        const int components = array->GetNumberOfComponents();
        for (int c = 0; c < components; ++c) {
            double before = std::nan("");
            for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
                const double value = array->GetComponent(i, c);
                const auto stored = static_cast<float>(value);
                if (is_real)
                    count.equal += value != before && stored == static_cast<float>(before) ? 1 : 0;
                else
                    count.integers += static_cast<double>(stored) != value ? 1 : 0;
                before = value;
            }
        }
        count.values += static_cast<std::uint64_t>(array->GetNumberOfValues());
    }
}

std::vector<std::string> ValueLoss::notes() const {
    std::vector<std::string> notes;
    for (const auto& [name, count] : counts_) {
        const std::string of = " of " + std::to_string(count.values) + " values of \"" + name + "\"";
        if (count.equal > 0)
            notes.push_back(std::to_string(count.equal) + of +
                            " differ from the value before in the input and are equal to it in the dataset, which "
                            "stores values as 32-bit floats.");
        if (count.integers > 0)
            notes.push_back(
                std::to_string(count.integers) + of +
                " are integers beyond 16,777,216 that a 32-bit float cannot hold exactly; the nearest float is kept.");
    }
    return notes;
}

} // namespace ciel::importer
