// The property of a volume on a mesh of the kernel.
#pragma once

#include "ciel/threshold_surface.hpp"
#include "geometry/slab_sink.hpp"
#include "support/kept.hpp"

namespace ciel::test {
using namespace server;

// Owns the arrays of a SlabProperty. The topology must outlive it.
struct VolumeProperty {
    const Topology* topology = nullptr;
    std::vector<float> values;
    std::vector<Vec3f> gradients;
    std::vector<std::uint8_t> filled;

    VolumeProperty() = default;
    VolumeProperty(const Topology& of_mesh, const FaceMeshView& mesh, std::vector<float> of_vertices)
        : topology(&of_mesh), values(std::move(of_vertices)), gradients(vertex_gradients(of_mesh, mesh, values)),
          filled(geometry::filled_cells({of_mesh, ValuesView(values), kept_by_test})) {}

    [[nodiscard]] geometry::SlabProperty view() const { return {*topology, values, gradients, filled}; }
    // `faces`: the boundary faces of the mesh, or all faces.
    [[nodiscard]] color::SlabTriangles boundary(const FaceMeshView& faces) const {
        const BlockBoxes boxes = block_boxes(*topology, faces.positions);
        return geometry::slab_boundary(threshold_surface(*topology, faces, boxes, filled, CollapsedFaces::keep),
                                       view());
    }
};

} // namespace ciel::test
