// GeometricVertices: the vertices at which the distance from a plane can have a local extremum, for planes of any
// direction (paper, section 4: "only the boundary vertices need to be traversed"). Erratum: the paper's statement needs
// convex cells. If all cells around an interior vertex are convex at the vertex, the edges of the vertex point in all
// directions, and the vertex is no extremum. If one of the cells has a reflex corner at the vertex, the vertex may be
// an extremum.
#pragma once

#include "ciel/field.hpp"
#include "ciel/threads.hpp"

#include <functional>

namespace ciel {

// Finds the vertices of one mesh, at fixed positions, that may be extrema for some direction. The first call of `find`
// computes the result, and later calls return it. Thread-safe. `mesh` may have only its boundary faces.
class GeometricVertices {
public:
    // Throws Error when `mesh` has no owner.
    explicit GeometricVertices(const FaceMeshView& mesh) : mesh_([mesh = mesh.owned()] { return mesh; }) {}
    // `mesh`: returns the mesh. The first call of `find` that succeeds calls and then destroys this function.
    explicit GeometricVertices(std::function<FaceMeshView()> mesh) : mesh_(std::move(mesh)) {}

    struct Found {
        // Vertex ids in ascending order: all boundary vertices, and the interior vertices with a reflex or flat corner.
        std::vector<Index> vertices;
        // If a field has a larger absolute distance, `vertices` may be incomplete for this field, because the distances
        // of two neighboring vertices may round to the same float.
        double largest_distance = 0;
    };
    // `topology` must be the topology of the same mesh, whose positions are loaded. Throws Error when a record cannot
    // be read. Uses all threads of parallel_for.
    [[nodiscard]] const Found& find(const Topology& topology) const;

private:
    mutable std::function<FaceMeshView()> mesh_; // empty once `found_` is made
    mutable Mutex mutex_;
    mutable Found found_;
};

} // namespace ciel
