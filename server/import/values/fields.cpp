#include "import/values/fields.hpp"

#include "import/values/array_facts.hpp"
#include "import/values/solver_ids.hpp"
#include "store/no_value.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <vtkAOSDataArrayTemplate.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace server::importer {

namespace {

constexpr const char* bookkeeping[] = {"vtkGhostType",   "vtkOriginalPointIds", "vtkOriginalCellIds",
                                       "IBlank",         "GlobalNodeId",        "GlobalElementId",
                                       "PedigreeNodeId", "PedigreeElementId",   "ObjectId",
                                       "vtkBlockColors", "vtkCompositeIndex",   "vtkValidPointMask"};

vtkDataSetAttributes* attributes(vtkDataSet* data, FieldOf of) {
    if (of == FieldOf::points) return data->GetPointData();
    return data->GetCellData();
}

bool is_bookkeeping(const std::string& name) {
    return std::find(std::begin(bookkeeping), std::end(bookkeeping), name) != std::end(bookkeeping);
}

std::string name_of(const vtkAbstractArray* array) {
    const char* name = const_cast<vtkAbstractArray*>(array)->GetName(); // NOLINT(cppcoreguidelines-pro-type-const-cast)
    return name == nullptr ? "" : name;
}

using Found = std::map<std::string, std::vector<FieldName>>; // array name -> description in each member with the array

void collect(const JoinedMesh::Member& member, FieldOf of, Found& found) {
    vtkDataSetAttributes* data = attributes(member.data, of);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
        vtkDataArray* array = data->GetArray(i); // null for an array of text
        if (array == nullptr) continue;
        const std::string name = name_of(array);
        if (name.empty() || is_bookkeeping(name) || array == solver_id_array(member.data, of)) continue;
        FieldName field{{of, name}, array->GetNumberOfComponents()};
        field.component_names = tensor_component_names(data, array);
        field.type = type_name(array);
        field.doubles = needs_doubles(array);
        found[name].push_back(std::move(field));
    }
}

bool have_equal_components(const std::vector<FieldName>& fields) {
    const std::string first = components_text(fields.front());
    return std::ranges::all_of(fields, [&](const FieldName& field) { return components_text(field) == first; });
}

// Returns p with wanted[i] == own[p[i]]; empty if the lists are equal or contain different names.
std::vector<std::size_t> permutation(const std::vector<std::string>& own, const std::vector<std::string>& wanted) {
    if (own == wanted || !std::ranges::is_permutation(own, wanted)) return {};
    std::vector<std::size_t> from;
    from.reserve(wanted.size());
    for (const std::string& name : wanted)
        from.push_back(static_cast<std::size_t>(std::ranges::find(own, name) - own.begin()));
    return from;
}

template <class T>
void permute(std::vector<T>& values, const std::vector<std::size_t>& from) {
    std::vector<T> tuple(from.size());
    for (std::size_t at = 0; at + from.size() <= values.size() && !from.empty(); at += from.size()) {
        for (std::size_t c = 0; c < from.size(); ++c) tuple[c] = values[at + from[c]];
        std::ranges::copy(tuple, values.begin() + static_cast<std::ptrdiff_t>(at));
    }
}

Found found_in(const std::vector<JoinedMesh::Member>& members, FieldOf of) {
    Found found;
    for (const JoinedMesh::Member& member : members) collect(member, of, found);
    return found;
}

std::string listed(const std::set<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

} // namespace

std::string components_text(const FieldName& field) {
    std::string text = std::to_string(field.components) + (field.components == 1 ? " component" : " components");
    std::vector<std::string> names = field.component_names;
    std::sort(names.begin(), names.end());
    for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? " (" : ", ") + names[i];
    return names.empty() ? text : text + ")";
}

std::vector<FieldName> field_names(const std::vector<JoinedMesh::Member>& members) {
    std::vector<FieldName> names;
    for (const FieldOf of : {FieldOf::points, FieldOf::cells})
        for (const auto& [name, fields] : found_in(members, of))
            if (have_equal_components(fields)) {
                names.push_back(fields.front());
                names.back().doubles = std::ranges::any_of(fields, &FieldName::doubles);
            }
    return names;
}

std::vector<std::string> left_out_arrays(const std::vector<JoinedMesh::Member>& members) {
    std::set<std::string> flags, texts, field_data;
    bool nameless = false;
    for (const JoinedMesh::Member& member : members) {
        for (const FieldOf of : {FieldOf::points, FieldOf::cells}) {
            vtkDataSetAttributes* data = attributes(member.data, of);
            for (int i = 0; i < data->GetNumberOfArrays(); ++i) {
                const std::string name = name_of(data->GetAbstractArray(i));
                nameless = nameless || name.empty();
                if (data->GetAbstractArray(i) == solver_id_array(member.data, of)) continue; // stored as solver ids
                if (is_bookkeeping(name))
                    flags.insert(name);
                else if (data->GetArray(i) == nullptr && !name.empty())
                    texts.insert(name);
            }
        }
        vtkFieldData* data = member.data->GetFieldData();
        for (int i = 0; i < data->GetNumberOfArrays(); ++i) field_data.insert(name_of(data->GetAbstractArray(i)));
    }
    std::vector<std::string> notes;
    if (!flags.empty()) notes.push_back("Flags and ids were left out: " + listed(flags) + ".");
    if (!texts.empty()) notes.push_back("Arrays of text were left out: " + listed(texts) + ".");
    if (!field_data.empty()) notes.push_back("Field data was left out: " + listed(field_data) + ".");
    if (nameless) notes.emplace_back("An array without a name was left out.");
    return notes;
}

std::vector<std::string> lost_arrays(const std::vector<JoinedMesh::Member>& members) {
    std::set<std::string> differing;
    for (const FieldOf of : {FieldOf::points, FieldOf::cells})
        for (const auto& [name, fields] : found_in(members, of))
            if (!have_equal_components(fields)) differing.insert(name);
    if (differing.empty()) return {};
    return {"Arrays whose components differ between blocks were left out: " + listed(differing) + "."};
}

std::vector<FieldName> field_names(const InputGrids& input_grids) {
    std::vector<JoinedMesh::Member> members;
    for (const InputGrid& input_grid : input_grids.volumes)
        members.push_back({input_grid.name, input_grid.data, 0, 0, 0, 0});
    return field_names(members);
}

namespace {

template <class T>
std::vector<T> values_as(vtkDataSet* data, const FieldName& field) {
    vtkDataArray* array = attributes(data, field.of)->GetArray(field.name.c_str());
    if (array == nullptr || array->GetNumberOfComponents() != field.components) return {};
    vtkNew<vtkAOSDataArrayTemplate<T>> numbers;
    numbers->DeepCopy(array); // converts to T
    const T* begin = numbers->GetPointer(0);
    std::vector<T> values(begin, begin + numbers->GetNumberOfValues());
    if (!field.component_names.empty())
        permute(values, permutation(tensor_component_names(attributes(data, field.of), array), field.component_names));
    return values;
}

template <class T>
store::Values gather_as(const std::vector<JoinedMesh::Member>& members, const FieldName& field) {
    const bool points = field.of == FieldOf::points;
    const auto size_of = [&](const JoinedMesh::Member& member) {
        return static_cast<std::size_t>(points ? member.data->GetNumberOfPoints() : member.data->GetNumberOfCells());
    };
    const auto first_of = [&](const JoinedMesh::Member& member) {
        return std::size_t{points ? member.first_point : member.first_cell};
    };
    std::size_t count = 0;
    for (const JoinedMesh::Member& member : members) count = std::max(count, first_of(member) + size_of(member));

    const auto components = static_cast<std::size_t>(field.components);
    std::vector<T> values(count * components, store::no_value);
    for (const JoinedMesh::Member& member : members) {
        const std::vector<T> own = values_as<T>(member.data, field);
        if (own.empty()) continue;
        if (own.size() != size_of(member) * components)
            throw ciel::Error("array \"" + field.name + "\" of block \"" + member.name + "\" has " +
                              std::to_string(own.size() / components) + " values; the number of values must be " +
                              std::to_string(size_of(member)) + ", one for each point or cell");
        std::copy(own.begin(), own.end(), values.begin() + static_cast<std::ptrdiff_t>(first_of(member) * components));
    }
    return store::Values(std::move(values));
}

} // namespace

store::Values array_values(vtkDataSet* data, const FieldName& field) {
    if (field.doubles) return store::Values(values_as<double>(data, field));
    return store::Values(values_as<float>(data, field));
}

store::Values gather_field(const std::vector<JoinedMesh::Member>& members, const FieldName& field) {
    return field.doubles ? gather_as<double>(members, field) : gather_as<float>(members, field);
}

} // namespace server::importer
