// GeometricVertices: the vertices at which the distance along some direction can have a local extremum (paper, section
// 4: "only the boundary vertices need to be traversed"). Erratum: the paper's statement needs convex cells. An interior
// vertex is never an extremum if all its cells are convex at it, because their edges then point in all directions. An
// interior vertex with a reflex corner may be an extremum.
#pragma once

#include "ciel/field.hpp"
#include "ciel/threads.hpp"

#include <functional>

namespace ciel {

// Candidates for extrema in one mesh at fixed positions, valid for all directions. The first call of `find` computes
// them. Thread-safe. The mesh may have only its boundary faces. `keep_alive` owns the arrays of the mesh.
class GeometricVertices {
public:
    GeometricVertices(const FaceMeshView& mesh, std::shared_ptr<const void> keep_alive)
        : mesh_([mesh, keep_alive = std::move(keep_alive)] { return mesh; }) {}
    // The first call of `find` calls `mesh` to get the mesh, whose arrays must live as long as the function object.
    explicit GeometricVertices(std::function<FaceMeshView()> mesh) : mesh_(std::move(mesh)) {}

    struct Found {
        // Ids in ascending order: boundary vertices, and interior vertices with a reflex or flat corner.
        std::vector<Index> vertices;
        // `vertices` is complete only for fields whose absolute distances do not exceed this. Larger distances may
        // round to the same float at neighboring vertices.
        double largest_distance = 0;
    };
    // `topology` must be that of the same mesh. Uses all threads of the parallel loop.
    [[nodiscard]] const Found& find(const Topology& topology) const;

private:
    std::function<FaceMeshView()> mesh_;
    mutable Mutex mutex_;
    mutable bool made_ = false;
    mutable Found found_;
};

} // namespace ciel
