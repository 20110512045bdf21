// The stored form of one mesh of the input, and how the input's values map to it.
#pragma once

#include "import/mesh/joined_mesh.hpp"
#include "import/mesh/patches.hpp"
#include "import/mesh/welds.hpp"
#include "store/writer.hpp"

namespace ciel::importer {

struct StepMesh {
    std::vector<JoinedMesh::Member> parts; // of the step read last: the same blocks at its time
    Index point_count = 0;
    Assembled assembled;
    std::vector<Index> point_of_vertex; // stored vertex -> running point
    std::vector<Index> cell_of_cell;    // stored cell -> running cell
    std::vector<Patch> patches;
    std::vector<Seam> seams;  // welded
    PointPairs joined_pieces; // points of pieces that are one
    std::vector<store::NamedGroup> groups;
    std::uint64_t input_vertices = 0, input_edges = 0, input_cells = 0; // as the file has them
    std::uint64_t bad_cells = 0;
    std::vector<std::string> notes;

    [[nodiscard]] FaceMeshView view() const { return assembled.mesh.view(); }
};

// Throws Error when there is no volume cell, or none that can be used.
[[nodiscard]] StepMesh build_step_mesh(const DataSets& data_sets, Weld weld, const SeamDifference& difference);

// The same cells at another time: takes the step's data, and its positions when they have moved.
void update_step_mesh(StepMesh& mesh, const DataSets& data_sets, bool moved);

// components values per item of `running`, picked for each stored vertex or cell.
[[nodiscard]] std::vector<float> to_stored(std::span<const float> running, std::span<const Index> stored_to_running,
                                           int components);

// Likewise of ids; nothing of nothing.
[[nodiscard]] std::vector<std::int64_t> to_stored(std::span<const std::int64_t> running,
                                                  std::span<const Index> stored_to_running);

} // namespace ciel::importer
