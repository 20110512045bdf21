// Field: a scalar field on the vertices of a mesh, with [min, max] per block and cached extrema and gradients (paper:
// slices, section 2.1; minima, section 2.2; gradients, section 3).
#pragma once

#include "ciel/array_view.hpp"
#include "ciel/block_ranges.hpp"
#include "ciel/cell_fits.hpp"
#include "ciel/mesh.hpp"
#include "ciel/value_source.hpp"

#include <memory>
#include <span>
#include <vector>

namespace ciel {

class GeometricVertices; // geometric_vertices.hpp

// Copies share everything. Values never change. Values in block order, ranges of cells, sorted extrema and gradients
// are caches that are filled on demand under locks. Thread-safe, except set_direction, set_cell_fits
// and vertices_moved.
class Field {
public:
    // Makes a field from one number per point of the mesh, in the caller's order; copies them: 8-bit integers and
    // 32-bit floats as floats, all others as doubles. NaN and infinities mean "no value": a cell that touches a point
    // without a value is not cut and adds nothing to gradients. Throws Error on another number of values. Keeps the
    // mesh alive.
    Field(const Mesh& mesh, const ArrayView& values);
    // Makes a field from one number per cell. A point gets a weighted mean of the cells around it, which is exact for
    // linear fields if the cells surround the point (point_interpolation.hpp). Not in the paper, whose values are at
    // points. Throws Error on another number of values.
    [[nodiscard]] static Field from_cells(const Mesh& mesh, const ArrayView& values);
    // Makes the signed distance from the plane through `origin` perpendicular to `normal`, which must have unit length.
    // The iso-surface at 0 is a slice. The values are doubles if the positions are.
    [[nodiscard]] static Field plane(const Mesh& mesh, const Vec3d& origin, const Vec3d& normal);
    // Makes the same distance on the vertices of a topology. points: their positions; faces are not used, and positions
    // are loaded when they are read. boxes: what block_boxes returned for these positions. Computes the distances in a
    // block when the block is cut, so a plane that crosses few blocks costs little. `keep_alive` owns the positions.
    // The topology must outlive the field. Throws Error when the topology, the points and the boxes differ in their
    // numbers of vertices or blocks.
    [[nodiscard]] static Field plane(const Topology& topology, const FaceMeshView& points, const Vec3d& origin,
                                     const Vec3d& normal, const BlockBoxes& boxes,
                                     std::shared_ptr<const void> keep_alive);
    // Uses one value per vertex in the topology's vertex order, without a copy. `keep_alive` owns the values, which
    // must not change while the field lives. The topology must outlive the field. Throws Error on another number of
    // values.
    Field(const Topology& topology, ValuesView values, std::shared_ptr<const void> keep_alive);
    // Likewise, with ranges that block_ranges returned for these values. Reads no value and no block. Throws Error on
    // another number of blocks.
    Field(const Topology& topology, ValuesView values, BlockRanges ranges, std::shared_ptr<const void> keep_alive);
    // Uses values that are read when a block is first cut. ranges: what block_ranges returned for them. Reads nothing.
    // Throws Error on another number of values or blocks.
    Field(const Topology& topology, std::shared_ptr<const ValueSource> source, BlockRanges ranges);
    ~Field();
    Field(const Field&);
    Field& operator=(const Field&);
    Field(Field&&) noexcept;
    Field& operator=(Field&&) noexcept;

    [[nodiscard]] const Mesh* mesh() const;            // null if the field was made from a Topology
    [[nodiscard]] ValuesView values() const;           // empty if they are computed or read when they are needed
    [[nodiscard]] double value(Index vertex) const;    // in the topology's vertex order
    [[nodiscard]] std::array<double, 2> range() const; // [min, max] of the finite values; {0, 0} when there are none

    // Returns the vertices that are strict local minima under the order (value, vertex id), sorted in that order
    // (paper, section 2.2). Vertices without a value are neither minima nor neighbors.
    [[nodiscard]] std::span<const Index> sorted_minima() const;

    // Declares that the values are plane_distance(mesh, ., normal) on the mesh of `where`. Extrema are then searched
    // only at the vertices that `where` finds. Call it before any other use of the field.
    void set_direction(std::shared_ptr<const GeometricVertices> where, Vec3d normal);

    // Copies the values of all blocks into block order. Without this call each block is copied at its first use. Uses
    // all threads of the parallel loop.
    void take_in() const;

    // Lets gradients use and fill `fits`. Fields of a Mesh share those of the mesh. Without fits, the least squares of
    // polyhedra are solved for this field alone. Call it before any extraction. Throws Error when the fits are of
    // another topology.
    void set_cell_fits(std::shared_ptr<CellFits> fits);

    // Drops the cached gradients and the cell fits, which depend on positions. Must not run during an extraction from
    // this field.
    void vertices_moved();

    struct Data; // defined in src/fields/field_data.hpp, for the kernel only
    [[nodiscard]] const Data& data() const { return *data_; }

private:
    Field() = default;
    template <class T>
    Field(const Mesh& mesh, const std::shared_ptr<const std::vector<T>>& stored);
    std::shared_ptr<Data> data_;
};

// Returns dot(normal, position - origin) per vertex, as floats. `origin` and the positions are in world coordinates. An
// iso-surface of the result is a slice (paper, section 2.1).
[[nodiscard]] std::vector<float> plane_distance(const FaceMeshView& mesh, Vec3d origin, Vec3d normal);

// Returns a gradient per vertex: the mean of the least-squares gradients of the cells around it, weighted by volume
// (paper, section 3). Zero if none of these cells has both a volume and finite values at all vertices.
[[nodiscard]] std::vector<Vec3f> vertex_gradients(const FaceMeshView& mesh, ValuesView values);
// Returns the same gradients faster, because the topology of `mesh` need not be built.
[[nodiscard]] std::vector<Vec3f> vertex_gradients(const Topology& topology, const FaceMeshView& mesh,
                                                  ValuesView values);

// Returns the number of faces that are ambiguous for some nu (paper, section 4): their loop has more than one local
// maximum under the order (value, vertex id). Faces with a vertex without a value do not count. boundary: the mesh, or
// its boundary faces alone. Reads the cells of all blocks. Throws Error unless there is one value per vertex.
[[nodiscard]] std::uint64_t count_ambiguous_faces(const Topology& topology, const FaceMeshView& boundary,
                                                  ValuesView values);

} // namespace ciel
