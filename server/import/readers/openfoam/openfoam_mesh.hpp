// The mesh of one region of an OpenFOAM case at one time. The points and cells of all pieces are numbered
// consecutively.
#pragma once

#include "import/mesh/pieces.hpp"
#include "import/parsers/openfoam/poly_mesh.hpp"
#include "import/readers/openfoam/openfoam_case.hpp"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

namespace server::importer {

struct FoamPiece {        // the cells and boundary faces of one root
    std::size_t root = 0; // index into FoamCase::roots
    std::size_t first_cell = 0, cell_count = 0;
    std::vector<FoamPatch> patches;          // with face ids of the piece
    std::size_t first_boundary_face = 0;     // face id in the piece of the first boundary face
    std::vector<std::size_t> boundary_owner; // index among the boundary faces -> cell of the piece
};

struct FoamSurface { // a patch, or a zone of faces, over all pieces
    std::string name, type;
    std::vector<std::string> groups;
    vtkSmartPointer<vtkCellArray> faces; // polygons of point ids of the mesh
};

struct FoamMesh {
    vtkSmartPointer<vtkPoints> points;         // 64-bit floats
    vtkSmartPointer<vtkUnstructuredGrid> grid; // polyhedra on `points`; its global ids are cellProcAddressing, if known
    std::vector<FoamSurface> patches;          // all patches except processor patches
    std::vector<FoamSurface> face_zones;
    std::map<std::string, std::vector<ciel::Index>> cell_zones;
    std::vector<FoamPiece> pieces;
    PointPairs same_points; // points to join along processor patches
    std::uint64_t joined_faces = 0, single_faces = 0;
    std::vector<std::string> lost; // sentences on pieces that cannot be read
};

// Leaves out pieces that cannot be read. If all pieces are left out, throws the Error of the first piece.
[[nodiscard]] FoamMesh read_foam_mesh(const FoamCase& foam, const std::string& region, double time);

// Returns the paths of the mesh files that are valid at `time`. Two times with equal lists have the same mesh.
[[nodiscard]] std::vector<std::filesystem::path> foam_mesh_files(const FoamCase& foam, const std::string& region,
                                                                 double time);

} // namespace server::importer
