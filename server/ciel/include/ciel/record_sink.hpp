// Builds the records of a topology one by one, so that they need not be in memory together. Not in the paper, whose
// structure has no blocks.
#pragma once

#include "ciel/matched_cells.hpp"
#include "ciel/topology.hpp"

#include <cstdint>
#include <vector>

namespace ciel {

// Takes the records of a topology that is being built.
class RecordSink {
public:
    RecordSink() = default;
    RecordSink(const RecordSink&) = delete;
    RecordSink& operator=(const RecordSink&) = delete;
    virtual ~RecordSink() = default;

    // `record`: the bytes of RecordSource::record as 64-bit words. Calls do not overlap, but may come from different
    // threads. Their order depends on the mesh and the block size only: `cells` in ascending order of the blocks, the
    // other kinds when the last block has been built that shares a vertex or a face with the block. No call follows a
    // call that throws.
    virtual void put(Index block, RecordKind kind, std::vector<std::uint64_t> record) = 0;
};

// What a Topology needs besides the records.
struct BuiltRecords {
    std::vector<std::uint64_t> tables; // as Topology::tables
    TopologyCounts counts;
};

// Build all records, give them to the sink, and return the rest of the topology. Use all threads of parallel_for.
// Throw the exceptions of Topology::Topology and of the sink. The sink may then have a part of the records. Both
// functions make the same records of the same cells, unless faces have repeated vertices: blocks may then end at other
// cells.
[[nodiscard]] BuiltRecords build_records(const FaceMeshView& mesh, RecordSink& sink, Topology::Options options = {});
[[nodiscard]] BuiltRecords build_records(const MatchedCells& cells, RecordSink& sink, Topology::Options options = {});

} // namespace ciel
