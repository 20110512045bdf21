// Iso-surfaces and slices from the topology and a field (paper, algorithms 1-4), kept incremental from one nu to the
// next.
#pragma once

#include "ciel/decider.hpp"
#include "ciel/field.hpp"
#include "ciel/threads.hpp"

#include <functional>

namespace ciel {

// One vertex of the surface lies on one active edge: position = lerp(a, b, t), and so does every other array.
struct EdgePoint {
    Index a, b; // mesh vertices, a < b
    float t;    // 0 at a, 1 at b
};

[[nodiscard]] inline float lerp(float a, float b, float t) {
    return static_cast<float>(a + static_cast<double>(t) * (static_cast<double>(b) - a));
}

// An indexed polygon surface. Vertices are shared across blocks, unique per active edge and in the order of edge ids;
// polygons are in storage order of their cells, wound so that the right-hand normal points to higher values. A cell
// that the surface crosses in several places has several polygons. On a face with more than one way to join its points,
// the high side is cut off corner by corner, or what the decider says. Polygons of fewer than three distinct points
// (collapsed cells) are left out, polygons without area are not. Every vertex belongs to a polygon. The same bits for
// any block size, thread count, algorithm and history of calls (`chunks` alone tells the blocks).
struct Surface {
    std::vector<Vec3f> positions; // offsets from the mesh's origin
    // Unit, towards higher values: see Normals; empty if not asked for.
    std::vector<Vec3f> normals;
    std::vector<EdgePoint> points;
    std::vector<Index> polygon_offset{0}; // polygons + 1
    std::vector<Index> polygon_vertex;
    std::vector<Index> polygon_cell; // the cut cell of each polygon
    std::vector<Index> polygon_face; // of surfaces made of faces of the mesh: which; else empty

    // Consecutive polygons of one block: the unit of streaming and culling.
    struct Chunk {
        Index block, polygon_begin, polygon_end;
    };
    std::vector<Chunk> chunks;
};

enum class Normals {
    gradient, // along the field's gradient, or along the polygons around the point where it is zero or points against
              // them
    polygons  // along the polygons around the point, by area: nothing to make when the field has changed
};

// Block signatures; the paper's Algorithm 2; the paper's baseline without a list of active edges.
enum class Algorithm { signatures, propagation, naive };

// How a Query works; what it gives does not depend on the algorithm.
struct Extraction {
    // NOLINTNEXTLINE(google-explicit-constructor): an algorithm alone says most of it
    Extraction(Algorithm with_algorithm = Algorithm::signatures, Decider with_decider = Decider::isolate_high)
        : algorithm(with_algorithm), decider(with_decider) {}

    Algorithm algorithm;
    Decider decider;
};

// One viewer's query state on one field: signatures, active edges. Not thread-safe: one at a time; any number of
// Queries may share a Topology and Fields. The mesh view must outlive the Query.
class Query {
public:
    Query(const Topology& topology, const FaceMeshView& mesh, Extraction extraction = {});
    ~Query();
    Query(Query&&) noexcept;
    Query& operator=(Query&&) noexcept;

    // Changes the field (another array, a new time step); the topology is untouched. The field must outlive the next
    // call of set_field.
    void set_field(const Field& field);

    // How ambiguous faces are joined from the next extraction on.
    void set_decider(Decider decider);
    void set_normals(Normals normals); // which ones `extract` makes where it is asked to; gradient without it
    // The vertices have moved: `mesh` is the one that the topology was built from but for its positions. Gradients
    // belong to positions: Field::vertices_moved.
    void set_mesh(const FaceMeshView& mesh);

    // High means value >= nu; cells that touch a vertex without a value are not cut (field.hpp). Replaces `out`; its
    // buffers are used again. `normals` asks for them: set_normals. Returns
    // false, leaving `out` unspecified, when `stop` was requested; the Query stays usable. Uses all threads of the
    // parallel loop.
    bool extract(double nu, bool normals, Surface& out, const StopToken& stop = {});

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Algorithm 1 / 3: a series is one call. `sink` gets each value's surface in the given order; it may be kept by moving.
// False when stopped.
bool extract_series(Query& query, std::span<const double> values, bool normals,
                    const std::function<void(double nu, Surface&&)>& sink, const StopToken& stop = {});

// values: `components` per mesh vertex, interpolated at each point of the surface into `out`, interleaved too. Throws
// Error when `out` has another size.
void interpolate(std::span<const EdgePoint> points, std::span<const float> values, int components,
                 std::span<float> out);

// Fan triangulation from the first good corner of each polygon (the best one where none is good; of more than 64
// corners 64 or so are tried), by clipped ears where every fan folds over. Zero-area and repeated-vertex triangles are
// left out: three indices per triangle. Linear in the corners.
[[nodiscard]] std::vector<Index> triangulate(const Surface& surface);
void triangulate(const Surface& surface, std::vector<Index>& out); // its buffer is used again

} // namespace ciel
