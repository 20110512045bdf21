// The boundary of a volume on a mesh of the kernel.
#pragma once

#include "ciel/threshold_surface.hpp"
#include "geometry/slab_sink.hpp"

namespace ciel::test {
using namespace server;

// `faces`: the boundary faces of the mesh, or all faces. `boxes`: the result of block_boxes for the positions.
[[nodiscard]] inline color::SlabMesh volume_boundary(const Topology& topology, const FaceMeshView& faces,
                                                     const BlockBoxes& boxes, const geometry::SlabProperty& property) {
    const std::vector<std::uint8_t> filled = geometry::filled_cells(property.limits);
    return geometry::slab_boundary(threshold_surface(topology, faces, boxes, filled, CollapsedFaces::keep), property);
}

} // namespace ciel::test
