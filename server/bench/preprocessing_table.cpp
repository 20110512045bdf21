#include "bench/case.hpp"
#include "ciel/geometric_vertices.hpp"

#include <cmath>
#include <functional>
#include <optional>

namespace server::bench {

namespace {

store::Values coordinate(const ciel::FaceMeshView& mesh, std::size_t axis, double sign) {
    ciel::Vec3d normal{};
    normal[axis] = sign;
    return store::Values(ciel::plane_distance(mesh, mesh.surface_origin, normal));
}

// A field computes its extrema only once. Therefore each run has a new field.
Row minima_row(
    const Case& data, const std::string& what, const store::Values& values,
    const std::function<void(ciel::Field&)>& prepare = [](ciel::Field&) {}) {
    std::optional<ciel::Field> field;
    std::size_t found = 0;
    Row row = measure(
        what,
        [&] {
            found = field->sorted_minima().size();
            return 0;
        },
        [&] {
            field.emplace(field_of(data, values));
            prepare(*field);
        });
    row.note = std::to_string(found) + " minima";
    return row;
}

} // namespace

Table preprocessing_table(const Case& data) {
    Table table{"preprocessing", {}, {}};
    const auto add = [&](const std::string& what, const std::function<void()>& body) -> Row& {
        table.rows.push_back(measure(what, [&] {
            body();
            return 0;
        }));
        return table.rows.back();
    };
    add("open the dataset, verify its topology", [&] { (void)store::Dataset::open(data.path); });
    Row& construction = add("construction (Algorithm 5)", [&] { const ciel::Topology topology(data.mesh); });
    construction.note = std::to_string(static_cast<std::uint64_t>(
                            static_cast<double>(data.topology->counts().half_edges) / construction.wall.median)) +
                        " half-edges/s";
    add("make a field", [&] { const ciel::Field field = field_of(data, data.values); });
    add("make a field and copy its values into block order", [&] {
        const ciel::Field field = field_of(data, data.values);
        field.take_in();
    });
    add("gradients at all vertices", [&] { (void)ciel::vertex_gradients(*data.topology, data.mesh, data.values); });
    add("ambiguous faces", [&] { (void)ciel::count_ambiguous_faces(*data.topology, data.mesh, data.values); });
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
            table.rows.push_back(
                minima_row(data, std::string("minima of the geometry, ") + "XYZ"[axis] + (sign > 0 ? "+" : "-"),
                           coordinate(data.mesh, axis, sign)));
    std::shared_ptr<const ciel::GeometricVertices> where;
    Row& vertices = add("where slices may begin: boundary and reflex vertices", [&] {
        where = std::make_shared<const ciel::GeometricVertices>(data.mesh);
        (void)where->find(*data.topology);
    });
    vertices.note = std::to_string(where->find(*data.topology).vertices.size()) + " vertices";
    const double part = 1 / std::sqrt(3.0);
    const ciel::Vec3d screen{part, part, part};
    const store::Values distance(ciel::plane_distance(data.mesh, data.mesh.surface_origin, screen));
    table.rows.push_back(minima_row(data, "minima of a screen-aligned direction, all vertices", distance));
    table.rows.push_back(minima_row(data, "minima of a screen-aligned direction, those vertices", distance,
                                    [&](ciel::Field& field) { field.set_direction(where, screen); }));
    table.rows.push_back(minima_row(data, "minima of the property", data.values));
    return table;
}

} // namespace server::bench
