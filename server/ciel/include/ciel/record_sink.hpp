// Builds the records of a topology (record_source.hpp) one by one, so that not all records need be in memory at the
// same time. Not in the paper, whose structure has no blocks.
#pragma once

#include "ciel/matched_cells.hpp"
#include "ciel/topology.hpp"

#include <cstdint>
#include <vector>

namespace ciel {

// Receives the records of a topology while build_records builds it.
class RecordSink {
public:
    RecordSink() = default;
    RecordSink(const RecordSink&) = delete;
    RecordSink& operator=(const RecordSink&) = delete;
    virtual ~RecordSink() = default;

    // `record`: the bytes of RecordSource::record as 64-bit words. Calls do not overlap, but may come from different
    // threads. The order of the calls depends only on the mesh and the block size. Records of the kind `cells` come in
    // ascending order of the blocks. A record `around` comes after all blocks that share a vertex with its block are
    // built, and a record `mates` after all blocks that share a face. After a call that throws, there are no further
    // calls.
    virtual void put(Index block, RecordKind kind, std::vector<std::uint64_t> record) = 0;
};

// The data of a Topology that is not in records.
struct BuiltRecords {
    std::vector<std::uint64_t> tables; // the result of Topology::tables
    TopologyCounts counts;
};

// Build all records, give them to the sink, and return the rest of the topology. Use all threads of parallel_for.
// Throw the exceptions of Topology::Topology and of the sink. After an exception, the sink may have only some of the
// records. Both functions make the same records of the same cells. Exception: if faces have repeated vertices, the two
// functions may divide the cells into different blocks.
[[nodiscard]] BuiltRecords build_records(const FaceMeshView& mesh, RecordSink& sink, Topology::Options options = {});
[[nodiscard]] BuiltRecords build_records(const MatchedCells& cells, RecordSink& sink, Topology::Options options = {});

} // namespace ciel
