#include "geometry/surface_values.hpp"

#include "geometry/cut.hpp"

#include <numeric>

namespace ciel::geometry {

namespace {

template <typename T>
std::vector<T> at(const std::vector<T>& of_vertices, const std::vector<Index>& vertices) {
    std::vector<T> found;
    if (of_vertices.empty()) return found;
    found.reserve(vertices.size());
    for (const Index vertex : vertices) found.push_back(of_vertices[vertex]);
    return found;
}

} // namespace

std::shared_ptr<const Shape> separated(const Shape& shape) {
    const Surface& whole = shape.surface;
    Surface apart;
    apart.positions = at(whole.positions, whole.polygon_vertex);
    apart.normals = at(whole.normals, whole.polygon_vertex);
    apart.points = at(whole.points, whole.polygon_vertex);
    apart.polygon_vertex.resize(whole.polygon_vertex.size());
    std::iota(apart.polygon_vertex.begin(), apart.polygon_vertex.end(), Index{0});
    apart.polygon_offset = whole.polygon_offset;
    apart.polygon_cell = whole.polygon_cell;
    apart.polygon_face = whole.polygon_face;
    return triangles_shape(std::move(apart));
}

store::Values flat_values(const Surface& separated, ValuesView of_polygons) {
    return of_polygons.with([&]<class T>(std::span<const T> all) {
        std::vector<T> flat(separated.positions.size());
        for (std::size_t i = 0; i < all.size(); ++i)
            for (Index corner = separated.polygon_offset[i]; corner < separated.polygon_offset[i + 1]; ++corner)
                flat[separated.polygon_vertex[corner]] = all[i];
        return store::Values(std::move(flat));
    });
}

} // namespace ciel::geometry
