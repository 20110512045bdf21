// Query: extracts iso-surfaces and slices of a field on a topology (paper, algorithms 1-4). nu is the iso-value.
// Extraction is incremental from one nu to the next.
#pragma once

#include "ciel/decider.hpp"
#include "ciel/field.hpp"
#include "ciel/threads.hpp"

#include <functional>
#include <optional>
#include <span>

namespace ciel {

// A vertex of the surface on an active edge. Its position and its value in any array are lerp(value at a, at b, t).
struct EdgePoint {
    Index a, b; // mesh vertices, a < b
    double t;   // 0 at a, 1 at b
};

[[nodiscard]] inline double lerp(double a, double b, double t) { return a + t * (b - a); }
[[nodiscard]] inline float lerp(float a, float b, double t) {
    return static_cast<float>(lerp(double{a}, double{b}, t));
}

// An indexed polygon surface. There is one vertex per active edge, in the order of edge ids; blocks share vertices.
// Polygons are in storage order of their cells. Their right-hand normal points to higher values. A cell that the
// surface crosses in several places has several polygons. The Decider chooses how points are joined on an ambiguous
// face.
// Polygons of fewer than three distinct points (collapsed cells) are left out; polygons without area are kept. Every
// vertex belongs to a polygon.
// The result has the same bits for any block size, thread count, algorithm and history of calls. Only `chunks` depends
// on the blocks.
struct Surface {
    std::vector<Vec3f> positions; // offsets from the mesh's surface_origin
    // One unit vector per vertex, towards higher values (see Normals); empty if not requested.
    std::vector<Vec3f> normals;
    std::vector<EdgePoint> points;
    std::vector<Index> polygon_offset{0}; // polygons + 1, into polygon_vertex
    std::vector<Index> polygon_vertex;
    std::vector<Index> polygon_cell; // mesh cell that each polygon cuts
    // For surfaces of mesh faces: index of each polygon's face in its FaceMeshView, or none; else empty.
    std::vector<Index> polygon_face;

    // Consecutive polygons of one block: the unit of streaming and culling.
    struct Chunk {
        Index block, polygon_begin, polygon_end;
    };
    std::vector<Chunk> chunks;
};

enum class Normals {
    // The normalized gradient of the field. Where the gradient is zero or points against the polygons around the point,
    // the area-weighted normal of these polygons.
    gradient,
    // The area-weighted normal of the polygons around the point. Faster after a change of the field, because no
    // gradients are computed.
    polygons
};

// How active edges are found; the surface is the same. signatures: per block, which vertices are high (the default).
// propagation: the paper's Algorithm 2, an active-edge list. naive: the paper's baseline, visits every cell.
enum class Algorithm { signatures, propagation, naive };

// Options of a Query. The algorithm affects the time, not the surface; the decider affects the surface.
struct Extraction {
    // NOLINTNEXTLINE(google-explicit-constructor): callers often pass only an algorithm
    Extraction(Algorithm with_algorithm = Algorithm::signatures, Decider with_decider = Decider::isolate_high)
        : algorithm(with_algorithm), decider(with_decider) {}

    Algorithm algorithm;
    Decider decider;
};

// Extracts surfaces of one field for one viewer, and keeps the signatures or active edges from call to call. Not
// thread-safe: one call at a time. Any number of Queries may share a Topology and Fields. The topology and the arrays
// of the mesh must outlive the Query. The constructor throws Error when the mesh and the topology differ in their
// numbers of vertices or cells.
class Query {
public:
    Query(const Topology& topology, const FaceMeshView& mesh, Extraction extraction = {});
    ~Query();
    Query(Query&&) noexcept;
    Query& operator=(Query&&) noexcept;

    // Sets the field to extract from, such as another array or time step. The field must live until the next call of
    // set_field. Throws Error when the field belongs to another topology.
    void set_field(const Field& field);

    // Sets how ambiguous faces are joined, from the next extraction on.
    void set_decider(Decider decider);
    void set_normals(Normals normals); // kind of normals that `extract` makes; default: gradient
    // Sets new positions of the vertices. `mesh` may differ only in its positions from the mesh that the topology was
    // built from. Call Field::vertices_moved too, because gradients depend on positions. Throws Error when the numbers
    // of vertices or cells differ.
    void set_mesh(const FaceMeshView& mesh);

    // Limits the next extractions to some blocks, in any order; nullopt, the default: all blocks. The surface then has
    // only the polygons in these blocks and the points of these polygons, with the same bits as in the surface of all
    // blocks. Normals from polygons may differ, because only the remaining polygons count. Without normals, only the
    // cells of these blocks are read, unless the algorithm is propagation. Throws Error if a block does not exist.
    void set_blocks(std::optional<std::span<const Index>> blocks);

    // Writes the iso-surface at `nu` to `out` and reuses its buffers. A vertex is high when its value >= nu. Cells that
    // touch a vertex whose value is NaN or infinite are not cut. `normals`: whether to make normals (set_normals).
    // Returns false, with `out` unspecified, when `stop` was requested; the Query stays usable. Throws Error when no
    // field is set. Uses all threads of the parallel loop.
    bool extract(double nu, bool normals, Surface& out, const StopToken& stop = {});

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Extracts the surfaces at several values (paper, algorithms 1 and 3). `sink` gets each surface in the order of
// `values` and may keep it by moving from it. Returns false when `stop` was requested.
bool extract_series(Query& query, std::span<const double> values, bool normals,
                    const std::function<void(double nu, Surface&&)>& sink, const StopToken& stop = {});

// Interpolates `values` at each point of the surface into `out`. Both arrays are interleaved: `values` has `components`
// numbers per mesh vertex, `out` as many per point. Throws Error when `out` has another size or `components` < 1.
void interpolate(std::span<const EdgePoint> points, std::span<const float> values, int components,
                 std::span<float> out);
void interpolate(std::span<const EdgePoint> points, std::span<const double> values, int components,
                 std::span<double> out);

// Returns three vertex indices per triangle. Each polygon becomes a triangle fan. The fan starts at the first corner
// that gives no thin or reversed triangle, else at the best corner. In a polygon of more than 64 corners only 64 to 127
// corners are tried. If every tried fan has a reversed triangle, ears are clipped. Triangles with zero area or a
// repeated vertex are left out. Takes time linear in the number of corners.
[[nodiscard]] std::vector<Index> triangulate(const Surface& surface);
void triangulate(const Surface& surface, std::vector<Index>& out); // writes to `out` and reuses its buffer

} // namespace ciel
