// GeometricVertices: the vertices at which the distance from a plane can have a local extremum, for planes of any
// direction (paper, section 4: "only the boundary vertices need to be traversed"). Erratum: the paper's statement needs
// convex cells. If all cells around an interior vertex are convex there, the edges of the vertex point in all
// directions, and the vertex is no extremum. An interior vertex with a reflex corner may be an extremum.
#pragma once

#include "ciel/field.hpp"
#include "ciel/threads.hpp"

#include <functional>

namespace ciel {

// Vertices of one mesh at fixed positions that may be extrema, for all directions. The first call of `find` computes
// them. Thread-safe. `mesh` may have only its boundary faces.
class GeometricVertices {
public:
    // Throws Error when `mesh` has no owner.
    explicit GeometricVertices(const FaceMeshView& mesh) : mesh_([mesh = mesh.owned()] { return mesh; }) {}
    // The first call of `find` that returns destroys the function `mesh`, from which it got the mesh.
    explicit GeometricVertices(std::function<FaceMeshView()> mesh) : mesh_(std::move(mesh)) {}

    struct Found {
        // Vertex ids in ascending order: all boundary vertices, and the interior vertices with a reflex or flat corner.
        std::vector<Index> vertices;
        // For fields with a larger absolute distance, `vertices` may be incomplete, because the distances of two
        // neighboring vertices may round to the same float.
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
