// Joins several surfaces to one surface, for file formats that hold one surface.
#pragma once

#include "wire/files/exported_surface.hpp"

namespace server::wire {

// Joins surfaces, and owns the joined arrays. Vertices of one added surface that lie on the same mesh vertex are merged
// if their values are equal. Normals are kept only if all added surfaces have normals. A named array of values is
// kept only if all added surfaces have an array of that name.
class JoinedSurface {
public:
    // Adds a surface. Each of `values` has one value per vertex of `surface`. `places`: as in ExportSurface.
    void add(const ciel::Surface& surface, const std::vector<NamedValues>& values,
             std::span<const ciel::Vec3d> places = {});
    [[nodiscard]] const ciel::Surface& surface() const { return surface_; }
    [[nodiscard]] const std::vector<NamedValues>& values() const { return values_; }
    // Returns the positions of the vertices, as precise as the mesh; an empty span if a surface was added without
    // `places`.
    [[nodiscard]] std::span<const ciel::Vec3d> places() const {
        return places_.size() == surface_.positions.size() ? std::span<const ciel::Vec3d>(places_)
                                                           : std::span<const ciel::Vec3d>();
    }

private:
    ciel::Surface surface_;
    std::vector<NamedValues> values_;
    std::vector<ciel::Vec3d> places_;
    bool is_first_ = true;
};

} // namespace server::wire
