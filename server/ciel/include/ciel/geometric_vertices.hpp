// Vertices at which the distance along some direction can have a local extremum (paper, section 4: "only the boundary
// vertices need to be traversed"). Erratum: that needs convex cells. An interior vertex is never an extremum if all of
// its cells are convex there, because their edges point in all directions. With a reflex corner it may be one.
#pragma once

#include "ciel/field.hpp"
#include "ciel/threads.hpp"

namespace ciel {

// For one mesh at fixed positions. Found once, at the first `find`, and valid for all directions. Thread-safe. Keeps
// the mesh alive through `keep_alive`.
class GeometricVertices {
public:
    GeometricVertices(const FaceMeshView& mesh, std::shared_ptr<const void> keep_alive)
        : mesh_(mesh), keep_alive_(std::move(keep_alive)) {}

    struct Found {
        std::vector<Index> vertices; // ascending: those on the boundary, and interior ones with a reflex or flat corner
        // Up to this distance, float resolves the differences that exclude the omitted vertices.
        double largest_distance = 0;
    };
    [[nodiscard]] const Found& find(const Topology& topology) const; // of the same mesh

private:
    FaceMeshView mesh_;
    std::shared_ptr<const void> keep_alive_;
    mutable Mutex mutex_;
    mutable bool made_ = false;
    mutable Found found_;
};

} // namespace ciel
