#include "store/cell_places.hpp"

#include "ciel/cell_geometry.hpp"
#include "ciel/mesh_faces.hpp"

namespace ciel::store {

std::map<Index, Vec3d> cell_places(const Topology& topology, const FaceMeshView& points,
                                   const std::vector<Index>& cells) {
    std::map<Index, Vec3d> places;
    for (const Index cell : cells) {
        if (places.contains(cell)) continue;
        const std::vector<Index> corners = corners_of_cell(topology, cell);
        points.load(corners);
        Vec3d place = points.origin;
        for (const Index vertex : corners)
            for (std::size_t axis = 0; axis < 3; ++axis)
                place[axis] += position(points, vertex)[axis] / static_cast<double>(corners.size());
        places.emplace(cell, place);
    }
    return places;
}

} // namespace ciel::store
