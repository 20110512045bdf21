#include "wasm/extract_everywhere.hpp"

#include "ciel/assemble.hpp"
#include "ciel/extract.hpp"
#include "support/views.hpp"
#include "wasm/cases.hpp"

#include <utility>

namespace ciel::test {
namespace {

constexpr std::array<std::pair<const char*, Engine>, 3> engines{
    {{"signatures", Engine::signatures}, {"propagation", Engine::propagation}, {"naive", Engine::naive}}};
constexpr Topology::Options small_blocks{16}; // so that small meshes have neighbours in other blocks too

class Results {
public:
    explicit Results(Bytes& bytes) : writer_(bytes) {}

    template <typename T>
    void record(const std::string& where, const char* what, std::span<const T> values) {
        writer_(where + " / " + what);
        writer_(values);
    }
    template <typename T>
    void record(const std::string& where, const char* what, const std::vector<T>& values) {
        record(where, what, std::span<const T>(values));
    }

private:
    Writer writer_;
};

void record_mesh(const std::string& where, const Assembled& assembled, Results& results) {
    results.record(where, "positions", assembled.mesh.positions);
    results.record(where, "faces", assembled.mesh.face_vertex);
    results.record(where, "owner", assembled.mesh.owner);
    results.record(where, "neighbour", assembled.mesh.neighbour);
    results.record(where, "original_cell", assembled.original_cell);
}

void record_operators(const std::string& where, const Topology& topology, Results& results) {
    std::vector<HalfEdge> found;
    for (Index cell = 0; cell < topology.counts().cells; ++cell) {
        for (HalfEdge h : topology.half_edges(cell)) {
            found.insert(found.end(),
                         {h, topology.vertex(h), topology.edge(h), topology.next_around_face(h),
                          topology.next_around_vertex(h), topology.mate_face(h), topology.mate_polyhedron(h)});
        }
    }
    results.record(where, "the six operators", found);
}

void record_surface(const std::string& where, const Surface& surface, std::span<const Vec3f> gradients,
                    Results& results) {
    results.record(where, "points", surface.points);
    results.record(where, "positions", surface.positions);
    results.record(where, "normals", surface.normals);
    results.record(where, "polygon_offset", surface.polygon_offset);
    results.record(where, "polygon_vertex", surface.polygon_vertex);
    results.record(where, "polygon_cell", surface.polygon_cell);
    results.record(where, "triangles", triangulate(surface));
    std::vector<Vec3f> colours(surface.points.size());
    interpolate(surface.points, {gradients.data()->data(), 3 * gradients.size()}, 3,
                {colours.data()->data(), 3 * colours.size()});
    results.record(where, "interpolated gradients", colours);
}

struct Meshes {
    const Assembled& assembled;
    const Topology& topology;
    [[nodiscard]] FaceMeshView view() const { return assembled.mesh.view(); }
};

void record_field(const std::string& where, const Meshes& meshes, const std::vector<float>& values,
                  const std::vector<double>& walk, Results& results) {
    const Field field(meshes.topology, values, nullptr);
    const std::vector<Vec3f> gradients = vertex_gradients(meshes.topology, meshes.view(), values);
    results.record(where, "range", std::span<const float>(field.range()));
    results.record(where, "minima", field.sorted_minima());
    results.record(where, "gradients", gradients);
    const std::array ambiguous{count_ambiguous_faces(meshes.view(), values)};
    results.record(where, "ambiguous faces", std::span<const std::uint64_t>(ambiguous));
    for (const auto& [name, engine] : engines) {
        Query query(meshes.topology, meshes.view(), engine);
        query.set_field(field);
        Surface surface;
        for (double nu : walk) {
            query.extract(nu, true, surface);
            record_surface(where + " / " + name + " at " + std::to_string(nu), surface, gradients, results);
        }
    }
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
    for (const CaseField& field : given.fields) {
        record_field(given.name + " / " + field.name, meshes, stored(assembled, field.values), field.walk, results);
    }
    const std::vector<float> distance = plane_distance(meshes.view(), given.slice_origin, given.slice_normal);
    results.record(given.name, "plane distance", distance);
    record_field(given.name + " / slice", meshes, distance, given.slice_walk, results);
}

} // namespace

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
