#include "geometry/surface_values.hpp"

#include "geometry/cut.hpp"

#include <numeric>

namespace server::geometry {

namespace {

template <typename T>
std::vector<T> at(const std::vector<T>& of_vertices, const std::vector<ciel::Index>& vertices) {
    std::vector<T> found;
    if (of_vertices.empty()) return found;
    found.reserve(vertices.size());
    for (const ciel::Index vertex : vertices) found.push_back(of_vertices[vertex]);
    return found;
}

} // namespace

std::shared_ptr<const Shape> separated(const Shape& shape) {
    const ciel::Surface& whole = shape.surface;
    ciel::Surface apart;
    apart.positions = at(whole.positions, whole.polygon_vertex);
    apart.normals = at(whole.normals, whole.polygon_vertex);
    apart.points = at(whole.points, whole.polygon_vertex);
    apart.polygon_vertex.resize(whole.polygon_vertex.size());
    std::iota(apart.polygon_vertex.begin(), apart.polygon_vertex.end(), ciel::Index{0});
    apart.polygon_offset = whole.polygon_offset;
    apart.polygon_cell = whole.polygon_cell;
    apart.polygon_face = whole.polygon_face;
    return triangles_shape(std::move(apart));
}

store::Values flat_values(const ciel::Surface& separated, ciel::ValuesView of_polygons) {
    return of_polygons.with([&]<class T>(std::span<const T> all) {
        std::vector<T> flat(separated.positions.size());
        for (std::size_t i = 0; i < all.size(); ++i)
            for (ciel::Index corner = separated.polygon_offset[i]; corner < separated.polygon_offset[i + 1]; ++corner)
                flat[separated.polygon_vertex[corner]] = all[i];
        return store::Values(std::move(flat));
    });
}

} // namespace server::geometry
