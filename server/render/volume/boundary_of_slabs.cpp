#include "render/volume/boundary_of_slabs.hpp"

#include <algorithm>
#include <cmath>

namespace server::render {

std::vector<std::vector<ciel::Index>> boundary_of_slabs(const Volume& volume) {
    const std::size_t slabs = (volume.slices.size() + volume.stride - 1) / volume.stride;
    const double thickness = volume.thickness * static_cast<double>(volume.stride);
    std::vector<std::vector<ciel::Index>> lists(slabs);
    const color::SlabTriangles& mesh = *volume.boundary;
    const auto place = [&](ciel::Index vertex) {
        const ciel::Vec3f& p = mesh.vertices[vertex].position;
        return (volume.normal[0] * p[0] + volume.normal[1] * p[1] + volume.normal[2] * p[2] - volume.first) / thickness;
    };
    const double last = static_cast<double>(slabs) - 1;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const ciel::Index* triangle = &mesh.triangles[i];
        const auto [low, high] = std::minmax({place(triangle[0]), place(triangle[1]), place(triangle[2])});
        constexpr double rounding = 1e-3;
        const auto begin = static_cast<std::size_t>(std::clamp(std::floor(low - rounding), 0.0, last));
        const auto end = static_cast<std::size_t>(std::clamp(std::floor(high + rounding), 0.0, last));
        for (std::size_t slab = begin; slab <= end; ++slab)
            lists[slab].insert(lists[slab].end(), triangle, triangle + 3);
    }
    return lists;
}

} // namespace server::render
