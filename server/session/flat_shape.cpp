#include "session/flat_shape.hpp"

#include "session/cut.hpp"

#include <numeric>

namespace ciel::session {

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
    return triangles_shape(std::move(apart));
}

std::vector<float> flat_values(const Surface& separated, std::span<const float> cell_values) {
    std::vector<float> values(separated.positions.size());
    for (std::size_t i = 0; i < separated.polygon_cell.size(); ++i) {
        const Index cell = separated.polygon_cell[i];
        if (cell >= cell_values.size()) throw Error("the surface belongs to another mesh than the values");
        for (Index corner = separated.polygon_offset[i]; corner < separated.polygon_offset[i + 1]; ++corner)
            values[separated.polygon_vertex[corner]] = cell_values[cell];
    }
    return values;
}

} // namespace ciel::session
