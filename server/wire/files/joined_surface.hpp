// Several surfaces as one, for files that hold one: the iso-values of a layer, or all layers.
#pragma once

#include "wire/files/exported_surface.hpp"

namespace ciel::wire {

// Owns its arrays. Vertices of one surface on the same mesh vertex are merged when their values are equal. Normals, and
// values of a name, are kept only if all added surfaces have them.
class JoinedSurface {
public:
    // values: one per vertex of `surface` in each.
    void add(const Surface& surface, const std::vector<NamedValues>& values);
    [[nodiscard]] const Surface& surface() const { return surface_; }
    [[nodiscard]] const std::vector<NamedValues>& values() const { return values_; }

private:
    Surface surface_;
    std::vector<NamedValues> values_;
    bool is_first_ = true;
};

} // namespace ciel::wire
