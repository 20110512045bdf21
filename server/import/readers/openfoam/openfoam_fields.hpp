// The fields of an OpenFOAM case at one time, on the cells and patches of a FoamMesh.
#pragma once

#include "import/readers/openfoam/openfoam_mesh.hpp"

#include <vtkDataArray.h>

namespace ciel::importer {

struct FoamFieldInfo {
    std::string units;
    int components = 0; // in most of the field's files
};
using FoamFieldInfos = std::map<std::string, FoamFieldInfo>; // by name

// Lists the fields of all times and regions, of the first processor of a decomposed case. Reads only the first 4 KiB of
// each file.
[[nodiscard]] FoamFieldInfos list_foam_fields(const FoamCase& foam);

struct FoamArrays { // of one field
    vtkSmartPointer<vtkDataArray> cells;
    std::vector<vtkSmartPointer<vtkDataArray>> patches; // in the order of FoamMesh::patches; null: no values
    std::vector<std::string> conditions;                // types, in the same order; empty: not in the file
};

// Returns arrays by field name. A part whose file is missing, damaged, or has other components than `infos` gets
// store::no_value, and a sentence is added to `lost`. Fields without any value are left out.
[[nodiscard]] std::map<std::string, FoamArrays> read_foam_fields(const FoamCase& foam, const std::string& region,
                                                                 double time, const FoamMesh& mesh,
                                                                 const FoamFieldInfos& infos,
                                                                 std::vector<std::string>& lost);

} // namespace ciel::importer
