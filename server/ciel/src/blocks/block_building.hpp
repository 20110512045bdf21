// Builds and links the blocks of a mesh, on all threads of parallel_for (paper, appendix A).
#pragma once

#include "blocks/block_records.hpp"
#include "ciel/record_sink.hpp"

namespace ciel::detail {

struct BuiltBlocks {
    BlockNumbers numbers;
    TopologyCounts counts;
};

// Throws the exceptions of Topology::Topology and of the sink.
[[nodiscard]] BuiltBlocks build_blocks(const FaceMeshView& mesh, Topology::Options options, RecordSink& sink);

} // namespace ciel::detail
