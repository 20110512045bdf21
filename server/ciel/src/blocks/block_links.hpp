// Links the built blocks of a mesh (paper, appendix A): mesh-wide ids, rings of the blocks of each shared vertex,
// owners of shared edges, and twins of tails.
#pragma once

#include "blocks/block_builder.hpp"

namespace ciel::detail {

// Moves all blocks of `mesh`, in order, to `out`. Sets all members of `out` except counts.faces, boundary_faces, cells
// and components. Throws Error when ids do not fit 32 bits, or when vertices are not in the order of first use.
void link_blocks(const FaceMeshView& mesh, std::vector<BuiltBlock>& built, Topology::Blocks& out);

} // namespace ciel::detail
