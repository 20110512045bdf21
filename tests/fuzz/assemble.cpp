// Fuzzes assemble, Topology and extract with a small mesh of arbitrary faces. Nothing crashes; accepted meshes keep the
// operators' identities, and all algorithms give the same closed surface.
#include "ciel/extract.hpp"
#include "fuzz/bytes.hpp"
#include "oracle/twin/twin.hpp"
#include "support/kept.hpp"
#include "support/views.hpp"

#include <algorithm>
#include <cmath>

namespace {

using namespace ciel;
using test::Bytes;
using test::number;
using test::require;
using test::same_bits;

// Returns an id out of range for few bytes only, so that most cells are accepted.
Index vertex_id(std::uint8_t byte, Index vertices) { return byte < 252 ? byte % vertices : vertices + byte - 252; }

test::Polyhedra read_mesh(Bytes& bytes) {
    constexpr std::uint8_t types[] = {10, 12, 13, 14, 42};
    test::Polyhedra mesh;
    const Index vertices = bytes.next() % 32U + 1;
    for (Index i = 0; i < 3 * vertices; ++i) mesh.positions.push_back(number(bytes.next()));
    for (int cells = bytes.next() % 12; cells > 0 && !bytes.empty(); --cells) {
        const std::uint8_t type = bytes.next();
        std::vector<test::Loop> loops(bytes.next() % 12);
        for (test::Loop& loop : loops) {
            loop.resize(bytes.next() % 8);
            for (Index& v : loop) v = vertex_id(bytes.next(), vertices);
        }
        mesh.add_cell(type < 250 ? types[type % 5] : type, loops);
    }
    return mesh;
}

// Damages a whole array. assemble must throw an Error or accept the mesh.
void damage(test::Polyhedra& mesh, Bytes& bytes) {
    const std::uint8_t what = bytes.next(), where = bytes.next();
    switch (what) {
    case 1:
        mesh.positions.resize(where);
        break;
    case 2:
        mesh.cell_types.resize(where, 42);
        break;
    case 3:
        mesh.cell_offset[where % mesh.cell_offset.size()] = bytes.next();
        break;
    case 4:
        mesh.face_offset[where % mesh.face_offset.size()] = bytes.next();
        break;
    case 5:
        mesh.face_offset[where % mesh.face_offset.size()] = ~std::uint64_t{0};
        break;
    case 6:
        mesh.cell_offset.resize(where % 4);
        break;
    case 7:
        mesh.face_offset.resize(where % 4);
        break;
    case 8:
        mesh.face_vertex.resize(where);
        break;
    default:
        break;
    }
}

void check_operators(const Topology& topology, Index cells) {
    std::size_t count = 0;
    for (Index c = 0; c < cells; ++c) {
        for (HalfEdge h : topology.half_edges(c)) {
            ++count;
            const HalfEdge mate = topology.mate_face(h), beyond = topology.mate_polyhedron(h);
            require(mate != h && topology.mate_face(mate) == h && topology.cell(mate) == c, "mate_face");
            require(topology.edge(mate) == topology.edge(h), "edge");
            require(topology.vertex(mate) != topology.vertex(h), "a half-edge from a vertex to itself");
            require(topology.vertex(topology.mate_face(topology.next_around_vertex(h))) == topology.vertex(mate),
                    "next_around_vertex");
            if (beyond == no_half_edge) continue;
            require(topology.mate_polyhedron(beyond) == h && topology.cell(beyond) != c, "mate_polyhedron");
            require(topology.vertex(beyond) == topology.vertex(mate), "mate_polyhedron runs the other way");
        }
    }
    require(count == topology.counts().half_edges, "the count of half-edges");
}

// Cells at a vertex without a finite value are not cut. A face that collapsed to a point counts as having no vertex.
std::vector<bool> cells_with_values(const FaceMeshView& mesh, std::span<const float> values) {
    std::vector<bool> result(mesh.cell_count(), true);
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const auto loop = mesh.loop(f);
        for (Index v : loop) {
            const bool is_point = std::count(loop.begin(), loop.end(), v) == std::ssize(loop);
            if (is_point || std::isfinite(values[v])) continue;
            result[mesh.owner[f]] = false;
            if (mesh.neighbour[f] != none) result[mesh.neighbour[f]] = false;
        }
    }
    return result;
}

void check_closed(const Surface& surface, const FaceMeshView& mesh, std::span<const float> values, double nu) {
    std::vector<test::CutPolygon> polygons;
    for (std::size_t p = 0; p + 1 < surface.polygon_offset.size(); ++p) {
        test::CutPolygon polygon{surface.polygon_cell[p], {}};
        for (Index i = surface.polygon_offset[p]; i < surface.polygon_offset[p + 1]; ++i) {
            const EdgePoint& point = surface.points[surface.polygon_vertex[i]];
            polygon.edges.emplace_back(point.a, point.b);
        }
        if (test::make_canonical(polygon)) polygons.push_back(std::move(polygon));
    }
    const std::vector<bool> cut = cells_with_values(mesh, values);
    test::Segments boundary;
    for (Index f = 0; f < mesh.face_count(); ++f) {
        const bool owner = cut[mesh.owner[f]], neighbour = mesh.neighbour[f] != none && cut[mesh.neighbour[f]];
        test::Loop loop(mesh.loop(f).begin(), mesh.loop(f).end());
        if (neighbour) std::reverse(loop.begin(), loop.end());
        if (owner != neighbour) test::add_face_segments(loop, values, nu, boundary);
    }
    const std::string open = test::open_segment(test::polygon_segments(polygons), boundary);
    require(open.empty(), open.c_str());
}

void cut(const Topology& topology, const FaceMeshView& mesh, Bytes& bytes) {
    std::vector<float> values(mesh.vertex_count());
    for (float& value : values) value = number(bytes.next());
    const Field field(topology, values, test::kept_by_test);
    Query signatures(topology, test::kept(mesh), Algorithm::signatures),
        propagation(topology, test::kept(mesh), Algorithm::propagation);
    signatures.set_field(field);
    propagation.set_field(field);
    for (int i = 0; i < 4; ++i) {
        const double nu = number(bytes.next());
        Surface a, b;
        require(signatures.extract(nu, true, a) && propagation.extract(nu, true, b), "nothing asked extract to stop");
        require(same_bits(a.points, b.points) && same_bits(a.positions, b.positions) &&
                    same_bits(a.normals, b.normals) && same_bits(a.polygon_offset, b.polygon_offset) &&
                    same_bits(a.polygon_vertex, b.polygon_vertex) && same_bits(a.polygon_cell, b.polygon_cell),
                "the algorithms differ");
        for (const EdgePoint& point : a.points) {
            require(point.a < point.b && point.b < mesh.vertex_count(), "a point off every edge");
            require(std::isfinite(values[point.a]) && std::isfinite(values[point.b]), "a point through no value");
            require(point.t >= 0 && point.t <= 1, "a point beyond its edge");
        }
        if (!std::isnan(nu)) check_closed(a, mesh, values, nu);
        for (Index v : triangulate(a)) require(v < a.points.size(), "a triangle without a vertex");
    }
    (void)count_ambiguous_faces(topology, mesh, values);
    require(vertex_gradients(mesh, values).size() == values.size(), "as many gradients as vertices");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(data, size);
    const std::uint8_t cells_per_block = bytes.next();
    test::Polyhedra mesh = read_mesh(bytes);
    damage(mesh, bytes);
    try {
        const Assembled assembled = assemble(test::view(mesh));
        const FaceMeshView faces = assembled.mesh.view();
        const Topology topology(faces, {cells_per_block % 16U + 1});
        check_operators(topology, faces.cell_count());
        cut(topology, faces, bytes);
    } catch (const Error&) {
    }
    return 0;
}
