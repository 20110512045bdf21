// Where a distance along a direction can have a local extremum, whatever the direction (paper, section 4: "only the
// boundary vertices need to be traversed"). Erratum: that needs convex cells. An interior vertex all of whose cells are
// convex there, so that their edges point all ways round, is none; one with a reflex corner may be.
#pragma once

#include "ciel/field.hpp"
#include "ciel/threads.hpp"

namespace ciel {

// Of one mesh in one place: found once, when the first field asks, and good for all directions. Any thread. Keeps the
// mesh alive through `keep_alive`.
class GeometricVertices {
public:
    GeometricVertices(const FaceMeshView& mesh, std::shared_ptr<const void> keep_alive)
        : mesh_(mesh), keep_alive_(std::move(keep_alive)) {}

    struct Found {
        std::vector<Index> vertices; // ascending: those on the boundary, and interior ones with a reflex or flat corner
        // Distances up to this are told apart in float where the vertices that are left out need it.
        double largest_distance = 0;
    };
    [[nodiscard]] const Found& find(const Topology& topology) const; // the mesh's

private:
    FaceMeshView mesh_;
    std::shared_ptr<const void> keep_alive_;
    mutable Mutex mutex_;
    mutable bool made_ = false;
    mutable Found found_;
};

} // namespace ciel
