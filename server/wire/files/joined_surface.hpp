// Several surfaces as one, for files that hold one: the iso-values of a layer, or all layers.
#pragma once

#include "wire/files/exported_surface.hpp"

namespace ciel::wire {

// Owns its arrays. Vertices of one surface that lie on the same mesh vertex become one. Normals are kept only while
// every surface added has them, and values by name likewise.
class JoinedSurface {
public:
    // values: each one per vertex of `surface`.
    void add(const Surface& surface, const std::vector<NamedValues>& values);
    [[nodiscard]] const Surface& surface() const { return surface_; }
    [[nodiscard]] const std::vector<NamedValues>& values() const { return values_; }

private:
    Surface surface_;
    std::vector<NamedValues> values_;
    bool is_first_ = true;
};

} // namespace ciel::wire
