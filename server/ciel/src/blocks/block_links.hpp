// Links the built blocks of a mesh (paper, appendix A: the counterparts of faces and the lists of vertices). Assigns
// mesh-wide ids, links the blocks of each shared vertex in a ring, and finds the owner of each shared edge and the twin
// of each tail.
#pragma once

#include "blocks/block_builder.hpp"

namespace ciel {

// `built`: all blocks of `mesh`, in order. Moves them to `out`. Sets all members of `out` except counts.faces,
// boundary_faces, cells and components. Throws Error when ids do not fit 32 bits, or when the vertices are not in the
// order of their first use.
void link_blocks(const FaceMeshView& mesh, std::vector<BuiltBlock>& built, Topology::Blocks& out);

} // namespace ciel
