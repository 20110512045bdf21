// Iso-surfaces and slices of a field on a topology (paper, algorithms 1-4). Extraction is incremental from one nu to
// the next.
#pragma once

#include "ciel/decider.hpp"
#include "ciel/field.hpp"
#include "ciel/threads.hpp"

#include <functional>

namespace ciel {

// A vertex of the surface, on one active edge. Positions and all other arrays are lerp(a, b, t).
struct EdgePoint {
    Index a, b; // mesh vertices, a < b
    float t;    // 0 at a, 1 at b
};

[[nodiscard]] inline float lerp(float a, float b, float t) {
    return static_cast<float>(a + static_cast<double>(t) * (static_cast<double>(b) - a));
}

// An indexed polygon surface. Vertices are shared across blocks, unique per active edge and in the order of edge ids.
// Polygons are in storage order of their cells. Their right-hand normal points to higher values. A cell that the
// surface crosses in several places has several polygons. On a face with more than one way to join its points, the
// decider chooses.
// Polygons of fewer than three distinct points (collapsed cells) are left out; polygons without area are kept. Every
// vertex belongs to a polygon.
// The bits are the same for any block size, thread count, algorithm and history of calls. Only `chunks` depends on the
// blocks.
struct Surface {
    std::vector<Vec3f> positions; // offsets from the mesh's origin
    // Unit vectors towards higher values (see Normals); empty if not requested.
    std::vector<Vec3f> normals;
    std::vector<EdgePoint> points;
    std::vector<Index> polygon_offset{0}; // polygons + 1
    std::vector<Index> polygon_vertex;
    std::vector<Index> polygon_cell; // the cut cell of each polygon
    std::vector<Index> polygon_face; // mesh face of each polygon, for surfaces of mesh faces; else empty

    // Consecutive polygons of one block: the unit of streaming and culling.
    struct Chunk {
        Index block, polygon_begin, polygon_end;
    };
    std::vector<Chunk> chunks;
};

enum class Normals {
    gradient, // the field's gradient; the area-weighted normal of the polygons around the point where the gradient is
              // zero or points against them
    polygons  // area-weighted normal of the polygons around the point; a new field costs nothing extra
};

// signatures: block signatures. propagation: the paper's Algorithm 2. naive: the paper's baseline without a list of
// active edges.
enum class Algorithm { signatures, propagation, naive };

// Options of a Query. The result does not depend on the algorithm.
struct Extraction {
    // NOLINTNEXTLINE(google-explicit-constructor): callers often pass only an algorithm
    Extraction(Algorithm with_algorithm = Algorithm::signatures, Decider with_decider = Decider::isolate_high)
        : algorithm(with_algorithm), decider(with_decider) {}

    Algorithm algorithm;
    Decider decider;
};

// One viewer's query state on one field: signatures, active edges. Not thread-safe: one call at a time. Any number of
// Queries may share a Topology and Fields. The topology and the arrays of the mesh must outlive the Query. Throws Error
// when the mesh and the topology differ in their numbers of vertices or cells.
class Query {
public:
    Query(const Topology& topology, const FaceMeshView& mesh, Extraction extraction = {});
    ~Query();
    Query(Query&&) noexcept;
    Query& operator=(Query&&) noexcept;

    // Changes the field (another array, a new time step); the topology is untouched. The field must live until the next
    // call of set_field. Throws Error when it belongs to another topology.
    void set_field(const Field& field);

    // Sets how ambiguous faces are joined, from the next extraction on.
    void set_decider(Decider decider);
    void set_normals(Normals normals); // kind that `extract` makes on request; default: gradient
    // Sets moved vertices: `mesh` differs only in its positions from the mesh that the topology was built from.
    // Gradients depend on positions: call Field::vertices_moved too. Throws Error when the numbers of vertices or cells
    // differ.
    void set_mesh(const FaceMeshView& mesh);

    // High means value >= nu. Cells that touch a vertex without a value are not cut (field.hpp). Replaces `out` and
    // reuses its buffers. `normals`: whether to make normals (set_normals). Returns false, with `out` unspecified, when
    // `stop` was requested; the Query stays usable. Throws Error when no field is set. Uses all threads of the parallel
    // loop.
    bool extract(double nu, bool normals, Surface& out, const StopToken& stop = {});

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Algorithms 1 and 3: extracts a series of values in one call. `sink` gets the surfaces in the order of the values and
// may keep one by moving it. Returns false when stopped.
bool extract_series(Query& query, std::span<const double> values, bool normals,
                    const std::function<void(double nu, Surface&&)>& sink, const StopToken& stop = {});

// Interpolates `values` at each point of the surface into `out`. Both are interleaved; `values` has `components` per
// mesh vertex. Throws Error when `out` has another size than points * components, or `components` is below 1.
void interpolate(std::span<const EdgePoint> points, std::span<const float> values, int components,
                 std::span<float> out);

// Returns three indices per triangle. Each polygon becomes a fan from its first good corner, or from the best one if
// none is good. Of more than 64 corners about 64 are tried. Where every fan folds over, ears are clipped instead.
// Triangles with zero area or a repeated vertex are left out. Linear in the corners.
[[nodiscard]] std::vector<Index> triangulate(const Surface& surface);
void triangulate(const Surface& surface, std::vector<Index>& out); // reuses its buffer

} // namespace ciel
