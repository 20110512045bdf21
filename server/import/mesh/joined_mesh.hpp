// Joins all volumes of a step (InputGrids::volumes) into one mesh, the input of ciel::assemble.
#pragma once

#include "ciel/assemble.hpp"
#include "ciel/of_this_thread.hpp"
#include "import/source/input_grids.hpp"
#include "store/files/disk_vector.hpp"
#include "store/format/values.hpp"

#include <map>

namespace server::importer {

// Running ids number the points of all members consecutively, member after member. Likewise, they number the cells.
// Members that share a vtkPoints object also share the running ids of its points. A vertex of the joined mesh has the
// id of its running point. source_cell maps a cell of the joined mesh to its running cell.
struct JoinedMesh {
    // `folder`: where the lists of faces and corners are, if they are large (store/files/disk_vector.hpp).
    explicit JoinedMesh(const std::filesystem::path& folder = {})
        : cell_offset(on_disk<std::uint64_t>(folder)), face_offset(1, 0, on_disk<std::uint64_t>(folder)),
          corner_offset(on_disk<std::uint64_t>(folder)), face_vertex(on_disk<ciel::Index>(folder)),
          corner(on_disk<ciel::Index>(folder)) {}

    struct Member { // an input grid in the joined mesh
        std::string name;
        vtkSmartPointer<vtkDataSet> data;
        ciel::Index first_point = 0;                        // running id of the member's first point
        ciel::Index first_cell = 0;                         // running id of the member's first cell
        ciel::Index mesh_cell_begin = 0, mesh_cell_end = 0; // the member's cells in the joined mesh, end excluded
        int whole = -1;                                     // InputGrid::whole of the member
    };
    struct FacesOfCell { // of a standard cell
        std::vector<std::uint64_t> offset;
        std::vector<ciel::Index> vertex;
    };
    struct FlatCells { // cells of dimension 2 inside a volume
        std::size_t member = 0;
        std::vector<vtkIdType> cells; // VTK cell ids in the member
    };

    std::vector<Member> members;
    std::vector<FlatCells> flat_cells;
    ciel::Index point_count = 0; // number of running points
    std::uint64_t blanked_cells = 0;
    std::map<std::string, std::uint64_t> reduced_cells; // VtkShape::reduced_from -> number of cells
    std::uint64_t ignored_cells = 0;                    // cells of dimension 0 or 1; they are left out
    std::uint64_t convex_point_sets = 0;                // left out, because VTK lists no faces for them

    store::Values positions; // x, y, z of each running point, equal to the numbers in the input
    // As in PolyhedraView. Standard cells list their corners, except cells that the input gives as polyhedra.
    std::vector<std::uint8_t> cell_types;
    store::DiskVector<std::uint64_t> cell_offset, face_offset, corner_offset;
    store::DiskVector<ciel::Index> face_vertex, corner;
    std::vector<ciel::Index> source_cell; // cell of the joined mesh -> running cell

    [[nodiscard]] ciel::PolyhedraView view() const {
        return {{}, positions, cell_types, cell_offset, face_offset, face_vertex, corner_offset, corner};
    }
    // Calls f(loop) for each face of the cell. f must not call for_loops.
    template <class F>
    void for_loops(std::size_t cell, F&& f) const {
        auto& [offset, vertex] = ciel::of_this_thread<FacesOfCell>();
        offset.assign(1, 0);
        vertex.clear();
        const std::uint64_t corners = corner_offset.empty() ? 0 : corner_offset[cell + 1] - corner_offset[cell];
        if (corners > 0) {
            ciel::append_standard_faces(static_cast<ciel::CellType>(cell_types[cell]),
                                        std::span(corner).subspan(corner_offset[cell], corners), offset, vertex);
            for (std::size_t face = 0; face + 1 < offset.size(); ++face)
                f(std::span<const ciel::Index>(vertex).subspan(offset[face], offset[face + 1] - offset[face]));
        } else if (!cell_offset.empty()) {
            for (std::uint64_t face = cell_offset[cell]; face < cell_offset[cell + 1]; ++face)
                f(std::span(face_vertex).subspan(face_offset[face], face_offset[face + 1] - face_offset[face]));
        }
    }
    // Calls f(vertex) for each mention of a running point in a cell. The vertices may be changed.
    template <class Self, class F>
    static void for_vertices(Self& mesh, F&& f) {
        for (auto& vertex : mesh.corner) f(vertex);
        for (auto& vertex : mesh.face_vertex) f(vertex);
    }

private:
    template <class T>
    static store::DiskAllocator<T> on_disk(const std::filesystem::path& folder) {
        return folder.empty() ? store::DiskAllocator<T>() : store::DiskAllocator<T>(folder);
    }
};

// Returns a mesh with members and without cells. Throws Error if there are more than 2^32 - 2 points or cells.
[[nodiscard]] JoinedMesh number_members(const std::vector<InputGrid>& volumes,
                                        const std::filesystem::path& folder = {});

// Returns the numbers of running points and cells. Throws Error if one of the numbers exceeds 2^32 - 2.
[[nodiscard]] RunningCounts count_running(const std::vector<InputGrid>& volumes);

// Throws Error for a point id out of range, a damaged offset or face table, a cell with too few nodes, a coordinate
// that is not finite, or more than 2^32 - 2 points or cells.
[[nodiscard]] JoinedMesh join_input_grids(const std::vector<InputGrid>& volumes, const std::filesystem::path& folder);

// Returns x, y, z of each running point: floats if these are exact for all numbers of the input, else doubles.
[[nodiscard]] store::Values point_positions(const std::vector<JoinedMesh::Member>& members, ciel::Index point_count);

// Returns the number of edges, without those from a vertex to itself, which collapsed cells have.
[[nodiscard]] std::uint64_t count_edges(const JoinedMesh& mesh);

} // namespace server::importer
