#include "wasm/extract_everywhere.hpp"
#include "support/kept.hpp"

#include "support/views.hpp"
#include "wasm/results.hpp"

namespace ciel::test {
namespace {

constexpr Topology::Options small_blocks{16}; // small meshes have neighbors in other blocks, too

void record_mesh(const std::string& where, const Assembled& assembled, Results& results) {
    results.record(where, "positions", assembled.mesh.positions);
    results.record(where, "faces", assembled.mesh.face_vertex);
    results.record(where, "owner", assembled.mesh.owner);
    results.record(where, "neighbour", assembled.mesh.neighbour);
    results.record(where, "original_cell", assembled.original_cell);
}

void record_operators(const std::string& where, const Topology& topology, Results& results) {
    std::vector<std::uint64_t> found;
    const auto add = [&found](auto... ids) { (found.push_back(static_cast<std::uint64_t>(ids)), ...); };
    for (Index cell = 0; cell < topology.counts().cells; ++cell) {
        for (HalfEdge h : topology.half_edges(cell)) {
            add(h, topology.vertex(h), topology.edge(h), topology.next_around_face(h), topology.next_around_vertex(h),
                topology.mate_face(h), topology.mate_polyhedron(h));
        }
    }
    results.record(where, "the six operators", found);
}

void record_surface(const std::string& where, const Surface& surface, std::span<const Vec3f> gradients,
                    Results& results) {
    results.record(where, surface);
    results.record(where, "triangles", triangulate(surface));
    std::vector<Vec3f> colors(surface.points.size());
    interpolate(surface.points, std::span<const float>(gradients.data()->data(), 3 * gradients.size()), 3,
                {colors.data()->data(), 3 * colors.size()});
    results.record(where, "interpolated gradients", colors);
}

void record_field(const Meshes& meshes, const FieldPair& fields, Results& results) {
    const Field field(meshes.topology, fields.values, kept_by_test);
    const std::vector<Vec3f> gradients = vertex_gradients(meshes.topology, meshes.view(), fields.values);
    results.record(fields.where, "range", std::span<const double>(field.range()));
    results.record(fields.where, "minima", field.sorted_minima());
    results.record(fields.where, "gradients", gradients);
    const std::array ambiguous{count_ambiguous_faces(meshes.topology, meshes.view(), fields.values)};
    results.record(fields.where, "ambiguous faces", std::span<const std::uint64_t>(ambiguous));
    for (const auto& [name, algorithm] : algorithms) {
        Query query(meshes.topology, kept(meshes.view()), algorithm);
        query.set_field(field);
        Surface surface;
        for (double nu : fields.walk) {
            query.extract(nu, true, surface);
            record_surface(fields.where + " / " + name + " at " + std::to_string(nu), surface, gradients, results);
        }
    }
    record_changes(meshes, fields, results);
    record_sweeps(meshes, fields, results);
    record_selections(meshes, fields, results);
}

std::vector<float> stored(const Assembled& assembled, const std::vector<float>& input_values) {
    std::vector<float> values;
    for (Index v : assembled.original_vertex) values.push_back(input_values[v]);
    return values;
}

void record_case(const Case& given, Results& results) {
    const Assembled assembled = assemble(view(given.mesh));
    const Topology topology(assembled.mesh.view(), small_blocks);
    const Meshes meshes{assembled, topology};
    record_mesh(given.name, assembled, results);
    record_operators(given.name, topology, results);
    for (std::size_t i = 0; i < given.fields.size(); ++i) {
        const CaseField &field = given.fields[i], &other = given.fields[(i + 1) % given.fields.size()];
        const std::vector<float> values = stored(assembled, field.values), others = stored(assembled, other.values);
        record_field(meshes,
                     {given.name + " / " + field.name, values, others, field.walk, other.walk, given.slice_origin,
                      given.slice_normal},
                     results);
    }
    const std::vector<float> distance = plane_distance(meshes.view(), given.slice_origin, given.slice_normal);
    const std::vector<float> property = stored(assembled, given.fields[0].values);
    results.record(given.name, "plane distance", distance);
    record_field(meshes,
                 {given.name + " / slice", distance, property, given.slice_walk, given.fields[0].walk,
                  given.slice_origin, given.slice_normal},
                 results);
}

} // namespace

void Results::record(const std::string& where, const Surface& surface) {
    record(where, "points", surface.points);
    record(where, "positions", surface.positions);
    record(where, "normals", surface.normals);
    record(where, "polygon_offset", surface.polygon_offset);
    record(where, "polygon_vertex", surface.polygon_vertex);
    record(where, "polygon_cell", surface.polygon_cell);
}

Bytes extract_everywhere(std::span<const std::byte> cases) {
    Bytes bytes;
    Results results(bytes);
    for (Reader reader(cases); !reader.at_end();) {
        Case given;
        given.parts(reader);
        record_case(given, results);
    }
    return bytes;
}

} // namespace ciel::test
