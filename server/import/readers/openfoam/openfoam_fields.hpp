// The fields of an OpenFOAM case at one time, on the cells and patches of a FoamMesh.
#pragma once

#include "import/readers/openfoam/openfoam_mesh.hpp"

#include <vtkDataArray.h>

namespace ciel::importer {

struct FoamFieldInfo {
    std::string units;
    int components = 0; // that most times have
};
using FoamFieldInfos = std::map<std::string, FoamFieldInfo>; // by name

// Of all times and regions of the first part, by the heads of the files.
[[nodiscard]] FoamFieldInfos list_foam_fields(const FoamCase& foam);

struct FoamArrays { // of one field
    vtkSmartPointer<vtkDataArray> cells;
    std::vector<vtkSmartPointer<vtkDataArray>> patches; // as FoamMesh::patches; null where there are no values
    std::vector<std::string> conditions;                // as these; empty where the file does not say
};

// By name. What cannot be read, is missing on a part, or has other components than `infos` says, has no values (NaN),
// and a sentence goes to `lost`; a field without any value is left out.
[[nodiscard]] std::map<std::string, FoamArrays> read_foam_fields(const FoamCase& foam, const std::string& region,
                                                                 double time, const FoamMesh& mesh,
                                                                 const FoamFieldInfos& infos,
                                                                 std::vector<std::string>& lost);

} // namespace ciel::importer
