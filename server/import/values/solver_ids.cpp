#include "import/values/solver_ids.hpp"

#include <algorithm>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkVariant.h>

namespace server::importer {

namespace {

bool are_whole_numbers(vtkDataArray* ids) {
    return ids->GetNumberOfComponents() == 1 && ids->GetDataType() != VTK_FLOAT && ids->GetDataType() != VTK_DOUBLE;
}

} // namespace

vtkDataArray* solver_id_array(vtkDataSet* data, FieldOf of) {
    const bool points = of == FieldOf::points;
    vtkDataSetAttributes* attributes = data->GetCellData();
    if (points) attributes = data->GetPointData();
    for (vtkDataArray* ids :
         {attributes->GetGlobalIds(), attributes->GetArray(points ? "GlobalNodeId" : "GlobalElementId"),
          vtkDataArray::SafeDownCast(attributes->GetPedigreeIds()),
          attributes->GetArray(points ? "PedigreeNodeId" : "PedigreeElementId")})
        if (ids != nullptr && are_whole_numbers(ids)) return ids;
    return nullptr;
}

std::vector<std::int64_t> gather_solver_ids(const std::vector<JoinedMesh::Member>& members, FieldOf of) {
    constexpr std::int64_t not_given = -1;
    const bool points = of == FieldOf::points;
    std::vector<std::int64_t> ids;
    for (const JoinedMesh::Member& member : members) {
        vtkDataArray* own = solver_id_array(member.data, of);
        if (own == nullptr) continue;
        const std::size_t first = points ? member.first_point : member.first_cell;
        const auto count = static_cast<std::size_t>(own->GetNumberOfTuples());
        ids.resize(std::max(ids.size(), first + count), not_given);
        const auto* whole = vtkIdTypeArray::SafeDownCast(own);
        for (std::size_t i = 0; i < count; ++i)
            ids[first + i] = whole != nullptr ? whole->GetValue(static_cast<vtkIdType>(i))
                                              : own->GetVariantValue(static_cast<vtkIdType>(i)).ToTypeInt64();
    }
    if (ids.empty()) return ids;
    std::size_t all = 0;
    for (const JoinedMesh::Member& member : members)
        all = std::max<std::size_t>(all, points ? std::size_t{member.first_point} + member.data->GetNumberOfPoints()
                                                : std::size_t{member.first_cell} + member.data->GetNumberOfCells());
    ids.resize(all, not_given);
    return ids;
}

} // namespace server::importer
