// All volume blocks of a step as one mesh in the form ciel::assemble takes.
#pragma once

#include "ciel/assemble.hpp"
#include "import/source/data_sets.hpp"

#include <map>

namespace ciel::importer {

// Points and cells of the blocks are numbered through, block after block ("running ids"); blocks that share one
// vtkPoints object share their points. A joined vertex has the id of its point; a joined cell names its running id.
struct JoinedMesh {
    struct Member {
        std::string name;
        vtkSmartPointer<vtkDataSet> data;
        Index first_point = 0;
        Index first_cell = 0;                         // running
        Index mesh_cell_begin = 0, mesh_cell_end = 0; // joined cells
        int whole = -1;                               // as the block's
    };
    struct Surface { // cells of dimension 2 inside a volume block
        std::size_t part = 0;
        std::vector<vtkIdType> cells; // ids in the part
    };

    std::vector<Member> parts;
    std::vector<Surface> surfaces;
    Index point_count = 0; // running
    std::uint64_t blanked_cells = 0;
    std::map<std::string, std::uint64_t> reduced_cells; // "quadratic tetrahedra": n
    std::uint64_t ignored_cells = 0;                    // points and lines
    std::uint64_t convex_point_sets = 0;                // volumes without faces: left out

    Vec3d origin{};
    std::vector<float> positions;
    std::vector<std::uint8_t> cell_types;
    std::vector<std::uint64_t> cell_offset{0};
    std::vector<std::uint64_t> face_offset{0};
    std::vector<Index> face_vertex;
    std::vector<Index> source_cell; // joined cell -> running cell

    [[nodiscard]] PolyhedraView view() const {
        return {origin, positions, cell_types, cell_offset, face_offset, face_vertex};
    }
};

// What join_blocks numbers through. Throws Error where there are more than 2^32 - 2 points or cells.
[[nodiscard]] RunningCounts count_running(const std::vector<DataSet>& volumes);

// Throws Error naming the block when an index is out of range, an offset table is damaged, a vertex that a cell uses is
// not finite, or there are more than 2^32 - 2 vertices or cells.
[[nodiscard]] JoinedMesh join_data_sets(const std::vector<DataSet>& volumes);

// Bounds centre of the points; offsets from `origin` as floats. For a moving mesh: the same blocks at another time.
[[nodiscard]] Vec3d bounds_centre(const JoinedMesh& mesh);
[[nodiscard]] std::vector<float> point_offsets(const std::vector<JoinedMesh::Member>& parts, Index point_count,
                                               Vec3d origin);

// Distinct edges of the cells; an edge between a vertex and itself (a collapsed cell) does not count.
[[nodiscard]] std::uint64_t count_edges(const JoinedMesh& mesh);

} // namespace ciel::importer
