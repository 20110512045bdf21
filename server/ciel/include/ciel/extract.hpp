// Query: extracts iso-surfaces and slices of a field on a topology (paper, algorithms 1-4). nu is the iso-value. A
// vertex is high when its value >= nu, else low. An edge is active when one end is high and the other end is low. A
// Query keeps data from one nu to the next, so that a small change of nu costs little.
#pragma once

#include "ciel/decider.hpp"
#include "ciel/field.hpp"
#include "ciel/threads.hpp"

#include <functional>
#include <optional>
#include <span>

namespace ciel {

// A vertex of a surface. The vertex lies on a mesh edge. Its position is lerp(position of a, position of b, t); values
// of arrays are interpolated in the same way. In a surface of a Query, a < b.
struct EdgePoint {
    Index a, b; // the two ends of the edge; equal if the point is a mesh vertex
    double t;   // 0 at a, 1 at b
};

[[nodiscard]] inline double lerp(double a, double b, double t) { return a + t * (b - a); }
[[nodiscard]] inline float lerp(float a, float b, double t) {
    return static_cast<float>(lerp(double{a}, double{b}, t));
}

// An indexed polygon surface. Each active edge has one vertex of the surface; the vertices are in the order of edge
// ids. Polygons are in the storage order of their cells. The right-hand normal of a polygon points to higher values. If
// the surface crosses a cell in several places, the cell has several polygons. The Decider chooses how points are
// joined on an ambiguous face.
// Polygons of fewer than three distinct points (in collapsed cells) are left out. Polygons without area are kept. Every
// vertex belongs to a polygon.
// The surface has the same bits for any block size, number of threads, algorithm and history of calls. Only `chunks`
// depends on the blocks.
struct Surface {
    std::vector<Vec3f> positions; // offsets from the mesh's surface_origin
    // One unit vector for each vertex, towards higher values (see Normals). Zero if the polygons around the vertex have
    // no area. Empty if normals were not requested.
    std::vector<Vec3f> normals;
    std::vector<EdgePoint> points;
    // P + 1, for P polygons: index in polygon_vertex of the first vertex of each polygon.
    std::vector<Index> polygon_offset{0};
    std::vector<Index> polygon_vertex;
    std::vector<Index> polygon_cell; // P: the mesh cell that contains the polygon
    // P for a surface made of mesh faces: index of the face in a FaceMeshView; `none` if the view does not have the
    // face. Empty for other surfaces.
    std::vector<Index> polygon_face;

    // Consecutive polygons that are streamed and culled together. In a surface of a Query, these are the polygons of
    // one block. In other surfaces, `block` is the number of the chunk.
    struct Chunk {
        Index block, polygon_begin, polygon_end;
    };
    std::vector<Chunk> chunks;
};

enum class Normals {
    // The normalized gradient of the field. If the gradient at a point is zero, or points against the normal of
    // `polygons`, the normal of `polygons` replaces it.
    gradient,
    // The mean of the normals of the polygons around the point, weighted by area. After a change of the field this is
    // faster than `gradient`, because no gradients are computed.
    polygons
};

// How active edges are found. The surface does not depend on the algorithm.
// signatures (the default): cuts a block again only if nu changes which vertices of the block are high.
// propagation: moves a list of active edges from one nu to the next (the paper's Algorithm 2).
// naive: visits every cell for every nu (the paper's baseline).
enum class Algorithm { signatures, propagation, naive };

// Options of a Query. The algorithm affects only the time. The decider affects the surface.
struct Extraction {
    // NOLINTNEXTLINE(google-explicit-constructor): callers often pass only an algorithm
    Extraction(Algorithm with_algorithm = Algorithm::signatures, Decider with_decider = Decider::isolate_high)
        : algorithm(with_algorithm), decider(with_decider) {}

    Algorithm algorithm;
    Decider decider;
};

// Extracts surfaces of one field, and keeps the signatures or the active edges from call to call. Not thread-safe: one
// call at a time. Several Queries may share a Topology and Fields. The constructor throws Error when the mesh has no
// owner (FaceMeshView::keep_alive), and when the mesh and the topology have different numbers of vertices or cells.
class Query {
public:
    Query(const Topology& topology, const FaceMeshView& mesh, Extraction extraction = {});
    ~Query();
    Query(Query&&) noexcept;
    Query& operator=(Query&&) noexcept;

    // Sets the field to extract from, for example another array or time step, and keeps a copy of it. Throws Error when
    // the field belongs to another topology.
    void set_field(const Field& field);

    // Sets how points on ambiguous faces are joined, from the next extraction on.
    void set_decider(Decider decider);
    void set_normals(Normals normals); // which normals `extract` makes; default: gradient
    // Sets new positions of the vertices. `mesh` must equal the mesh from which the topology was built, except for the
    // positions. Call Field::vertices_moved too, because gradients depend on positions. Throws Error as the constructor
    // does.
    void set_mesh(const FaceMeshView& mesh);

    // Limits the next extractions to these blocks, in any order; nullopt: all blocks (the default). The surface then
    // has only the polygons in these blocks and the points of these polygons, with the same bits as in the surface of
    // all blocks. Exception: normals from polygons may differ, because polygons of other blocks are not summed. If no
    // normals are requested, only the cell records of these blocks are read. The propagation algorithm may also read
    // records of other blocks.
    // Throws Error when a block does not exist.
    void set_blocks(std::optional<std::span<const Index>> blocks);

    // Writes the iso-surface at `nu` to `out` and reuses the buffers of `out`. Cells with a vertex whose value is NaN
    // or infinite are not cut. `normals`: whether to make normals; set_normals chooses the kind. Returns false when
    // `stop` was requested; `out` is then unspecified, and the Query stays usable. Throws Error when no field is set,
    // and when a record, a value or a position cannot be read. Uses all threads of parallel_for.
    bool extract(double nu, bool normals, Surface& out, const StopToken& stop = {});

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// Extracts the surfaces at several values (paper, algorithms 1 and 3). Calls `sink` with each surface, in the order of
// `values`; the sink may move from the surface. Returns false when `stop` was requested. Throws what Query::extract and
// `sink` throw.
bool extract_series(Query& query, std::span<const double> values, bool normals,
                    const std::function<void(double nu, Surface&&)>& sink, const StopToken& stop = {});

// Interpolates an array at each point of a surface. `values`: `components` numbers for each mesh vertex, interleaved.
// REQUIRES: `values` has entries for all vertices in `points`.
// `out` gets `components` numbers for each point. Throws Error when `out` has another size, or when components < 1.
// Uses all threads of parallel_for.
void interpolate(std::span<const EdgePoint> points, std::span<const float> values, int components,
                 std::span<float> out);
void interpolate(std::span<const EdgePoint> points, std::span<const double> values, int components,
                 std::span<double> out);

// Returns three vertex indices for each triangle. A polygon becomes a fan of triangles. The fan starts at the first
// corner from which no triangle is thin or reversed. If there is no such corner, it starts at the corner with the best
// triangles. In a polygon of more than 64 corners, only 64 to 127 corners are tried. If a triangle is reversed in every
// fan tried, the polygon is triangulated by ear clipping. Triangles with zero area or a repeated vertex are left out.
// Takes time linear in the number of corners. Uses all threads of parallel_for.
[[nodiscard]] std::vector<Index> triangulate(const Surface& surface);
void triangulate(const Surface& surface, std::vector<Index>& out); // writes to `out` and reuses its buffer

} // namespace ciel
