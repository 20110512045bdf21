// The mesh of one region of an OpenFOAM case at one time, all its parts numbered through: points, faces and cells of
// the first processor come first.
#pragma once

#include "import/mesh/pieces.hpp"
#include "import/parsers/openfoam/poly_mesh.hpp"
#include "import/readers/openfoam/openfoam_case.hpp"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

namespace ciel::importer {

struct FoamPiece { // what one part has of the mesh
    std::size_t part = 0;
    std::size_t first_cell = 0, cell_count = 0;
    std::vector<FoamPatch> patches;          // faces as the part numbers them
    std::size_t first_boundary_face = 0;     // of the part
    std::vector<std::size_t> boundary_owner; // boundary face -> cell of the part
};

struct FoamSurface { // a patch, or a zone of faces, over all parts
    std::string name, type;
    std::vector<std::string> groups;
    vtkSmartPointer<vtkCellArray> faces; // with the points of the mesh
};

struct FoamMesh {
    vtkSmartPointer<vtkPoints> points; // 64-bit floats
    vtkSmartPointer<vtkUnstructuredGrid>
        grid;                         // has these points; all cells are polyhedra; the ids of a decomposed case's cells
    std::vector<FoamSurface> patches; // without those between processors
    std::vector<FoamSurface> face_zones;
    std::map<std::string, std::vector<Index>> cell_zones;
    std::vector<FoamPiece> pieces;
    PointPairs same_points; // along the faces between processors
    std::uint64_t joined_faces = 0, single_faces = 0;
    std::vector<std::string> lost; // sentences on parts that cannot be read
};

// Throws Error where no part can be read: that of the first.
[[nodiscard]] FoamMesh read_foam_mesh(const FoamCase& foam, const std::string& region, double time);

// The files that say what the mesh is at that time: equal lists mean equal meshes.
[[nodiscard]] std::vector<std::filesystem::path> foam_mesh_files(const FoamCase& foam, const std::string& region,
                                                                 double time);

} // namespace ciel::importer
