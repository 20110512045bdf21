// The fields of an OpenFOAM case at one time, on the cells and patches of a FoamMesh.
#pragma once

#include "import/readers/openfoam/openfoam_mesh.hpp"

#include <vtkDataArray.h>

namespace server::importer {

struct FoamFieldInfo {
    std::string units;
    int components = 0; // number of components in most files of the field
};
using FoamFieldInfos = std::map<std::string, FoamFieldInfo>; // by name

// For a decomposed case, lists the fields of the first processor. Reads only the first 4 KiB of each file.
[[nodiscard]] FoamFieldInfos list_foam_fields(const FoamCase& foam);

struct FoamArrays { // the arrays of one field
    vtkSmartPointer<vtkDataArray> cells;
    std::vector<vtkSmartPointer<vtkDataArray>> patches; // in the order of FoamMesh::patches; null: no values
    std::vector<std::string> conditions; // types of boundary conditions, in the same order; empty: not in the file
};

// Returns the arrays by field name. If the file of a piece is missing, is damaged, or has other components than
// `infos`, the piece gets store::no_value, and `lost` gets a sentence. Leaves out fields without any value.
[[nodiscard]] std::map<std::string, FoamArrays> read_foam_fields(const FoamCase& foam, const std::string& region,
                                                                 double time, const FoamMesh& mesh,
                                                                 const FoamFieldInfos& infos,
                                                                 std::vector<std::string>& lost);

} // namespace server::importer
