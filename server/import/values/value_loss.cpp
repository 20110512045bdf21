#include "import/values/value_loss.hpp"

#include "import/values/array_facts.hpp"

#include <cmath>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

namespace server::importer {
namespace {

// Counts values that differ from the previous value of the same component, but not after conversion to float.
std::uint64_t equal_as_floats(vtkDataArray* array) {
    std::uint64_t count = 0;
    for (int c = 0; c < array->GetNumberOfComponents(); ++c) {
        double before = std::nan("");
        for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
            const double value = array->GetComponent(i, c);
            count += value != before && static_cast<float>(value) == static_cast<float>(before) ? 1 : 0;
            before = value;
        }
    }
    return count;
}

// T: floating-point type of the dataset. Whole: integer type of the array.
template <class T, class Whole>
std::uint64_t unlike_integers(vtkDataArray* array) {
    const auto* begin = static_cast<const Whole*>(array->GetVoidPointer(0));
    constexpr auto half = Whole{1} << (std::numeric_limits<Whole>::digits - 1);
    constexpr T end_of_whole = 2 * static_cast<T>(half); // largest Whole + 1, which T holds exactly
    std::uint64_t count = 0;
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i) {
        const auto stored = static_cast<T>(begin[i]);
        count += stored >= end_of_whole || static_cast<Whole>(stored) != begin[i] ? 1 : 0;
    }
    return count;
}

template <class T>
std::uint64_t changed_integers(vtkDataArray* array) {
    const bool is_signed = type_name(array).starts_with("int");
    if (array->GetDataTypeSize() == sizeof(std::int64_t))
        return is_signed ? unlike_integers<T, std::int64_t>(array) : unlike_integers<T, std::uint64_t>(array);
    return is_signed ? unlike_integers<T, std::int32_t>(array) : unlike_integers<T, std::uint32_t>(array);
}

} // namespace

void ValueLoss::look_at(const std::vector<JoinedMesh::Member>& members, const FieldName& field, bool doubles) {
    Count& count = counts_[(field.of == FieldOf::cells ? "cell:" : "") + field.name];
    count.doubles = doubles;
    for (const JoinedMesh::Member& member : members) {
        vtkDataSetAttributes* data = member.data->GetPointData();
        if (field.of == FieldOf::cells) data = member.data->GetCellData();
        vtkDataArray* array = data->GetArray(field.name.c_str());
        if (array == nullptr || !needs_doubles(array)) continue;
        const bool is_real = array->GetDataType() == VTK_DOUBLE;
        if (is_real && !doubles) count.equal += equal_as_floats(array);
        if (!is_real) count.integers += doubles ? changed_integers<double>(array) : changed_integers<float>(array);
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
                            "stores the array as 32-bit floats, the type of its first step.");
        if (count.integers > 0)
            notes.push_back(std::to_string(count.integers) + of + " are integers beyond " +
                            (count.doubles ? "9,007,199,254,740,992 that a 64-bit" : "16,777,216 that a 32-bit") +
                            " float cannot hold exactly; the nearest float is kept.");
    }
    return notes;
}

} // namespace server::importer
