// Field: a scalar field on the vertices of a mesh. A field has [min, max] for each block, and caches extrema and
// gradients (paper: slices, section 2.1; minima, section 2.2; gradients, section 3).
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

// Copies share all data. The values never change. Four caches are filled on demand, under locks: the values in block
// order, the ranges of cells, the sorted extrema, and the gradients. Thread-safe, except set_direction, set_cell_fits
// and vertices_moved.
class Field {
public:
    // Makes a field from one number for each point of the mesh, in the caller's order. Copies the numbers: 8-bit
    // integers and 32-bit floats as floats, all other numbers as doubles. NaN and infinities mean "no value". If a
    // point of a cell has no value, the cell is not cut and does not contribute to gradients. Keeps the mesh alive.
    // Throws Error when `values` has another size.
    Field(const Mesh& mesh, const ArrayView& values);
    // Makes a field from one number for each cell, in the caller's order. A point gets a weighted mean of the cells
    // around the point (point_interpolation.hpp). The mean is exact for linear fields if the cells surround the point.
    // Not in the paper, whose values are at points. Throws Error when `values` has another size.
    [[nodiscard]] static Field from_cells(const Mesh& mesh, const ArrayView& values);
    // Makes the signed distance from a plane: positive on the side of `normal`, zero at `origin`, which is in the
    // coordinates of the caller's points. REQUIRES: `normal` has unit length. The iso-surface at 0 is a slice. The
    // values are doubles if the positions are doubles, else floats. Uses all threads of parallel_for.
    [[nodiscard]] static Field plane(const Mesh& mesh, const Vec3d& origin, const Vec3d& normal);
    // Makes the signed distance from a plane on the vertices of a topology. Computes the distances in a block when the
    // block is first cut, so that a plane that crosses few blocks costs little. `origin`: in world coordinates, that
    // is, position + points.origin. REQUIRES: `normal` has unit length. `points`: the positions of the vertices; the
    // faces are not used. `boxes`: the result of block_boxes for these positions. Throws Error when `points` has no
    // owner, and when the topology, the points and the boxes differ in their numbers of vertices or blocks.
    [[nodiscard]] static Field plane(const Topology& topology, const FaceMeshView& points, const Vec3d& origin,
                                     const Vec3d& normal, const BlockBoxes& boxes);
    // Makes a field from one value for each vertex, in the topology's vertex order. Does not copy the values.
    // `keep_alive` owns the values, which must not change while the field lives. Throws Error when `values` has another
    // size, and when `keep_alive` is null.
    Field(const Topology& topology, ValuesView values, std::shared_ptr<const void> keep_alive);
    // Makes a field like the previous constructor, but reads no value and no block. `ranges`: the result of
    // block_ranges for these values. Throws Error when `values` or `ranges` has another size, and when `keep_alive` is
    // null.
    Field(const Topology& topology, ValuesView values, BlockRanges ranges, std::shared_ptr<const void> keep_alive);
    // Makes a field from values that `source` reads, for each block when the block is first cut. `ranges`: the result
    // of block_ranges for these values. The constructor reads nothing. Throws Error when `source` or `ranges` has
    // another size.
    Field(const Topology& topology, std::shared_ptr<const ValueSource> source, BlockRanges ranges);
    ~Field();
    Field(const Field&);
    Field& operator=(const Field&);
    Field(Field&&) noexcept;
    Field& operator=(Field&&) noexcept;

    [[nodiscard]] const Mesh* mesh() const;            // null if the field was made from a Topology
    [[nodiscard]] ValuesView values() const;           // empty if values are computed or read on demand
    [[nodiscard]] double value(Index vertex) const;    // `vertex`: in the topology's vertex order
    [[nodiscard]] std::array<double, 2> range() const; // [min, max] of the finite values; {0, 0} when there are none

    // Returns the vertices that are strict local minima under the order (value, vertex id), sorted by this order
    // (paper, section 2.2). A vertex without a value is not a minimum, and is ignored as a neighbor. The result is
    // valid while the field lives.
    [[nodiscard]] std::span<const Index> sorted_minima() const;

    // Declares that the values are plane_distance(mesh, origin, normal), for any origin, on the mesh of `where`. The
    // search for extrema then tests only the vertices that `where` finds, unless distances are too large
    // (Found::largest_distance). Call it before any other use of the field.
    void set_direction(std::shared_ptr<const GeometricVertices> where, Vec3d normal);

    // Copies the values of all blocks into block order: block by block, all vertices of each block. Without this call,
    // the values of a block are copied when the block is first used. Uses all threads of parallel_for.
    void take_in() const;

    // Sets the CellFits that gradients of this field use and fill. A field made from a Mesh uses the CellFits of the
    // mesh. Without CellFits, the least squares of polyhedra are solved for this field alone. Call it before any
    // extraction. Throws Error when the CellFits belong to another topology.
    void set_cell_fits(std::shared_ptr<CellFits> fits);

    // Drops the cached gradients and the CellFits, because both depend on positions. Do not call it during an
    // extraction from this field.
    void vertices_moved();

    struct Data; // defined in src/fields/field_data.hpp, for the kernel only
    [[nodiscard]] const Data& data() const { return *data_; }

private:
    Field() = default;
    template <class T>
    Field(const Mesh& mesh, const std::shared_ptr<const std::vector<T>>& stored);
    std::shared_ptr<Data> data_;
};

// Returns dot(normal, position - origin) for each vertex, as floats. `origin` and the positions are in world
// coordinates. An iso-surface of the result is a slice (paper, section 2.1). Uses all threads of parallel_for.
[[nodiscard]] std::vector<float> plane_distance(const FaceMeshView& mesh, Vec3d origin, Vec3d normal);

// Returns the gradient at each vertex, in units of the values per unit of length: the mean of the least-squares
// gradients of the cells around the vertex, weighted by cell volume (paper, section 3). The gradient is zero if no cell
// around the vertex has both a volume and finite values at all vertices. Throws Error when `values` has another size.
// Uses all threads of parallel_for.
[[nodiscard]] std::vector<Vec3f> vertex_gradients(const FaceMeshView& mesh, ValuesView values);
// Returns the same gradients. Faster, because no topology needs to be built.
[[nodiscard]] std::vector<Vec3f> vertex_gradients(const Topology& topology, const FaceMeshView& mesh,
                                                  ValuesView values);

// Returns the number of faces that are ambiguous for some iso-value (paper, section 4): the loop of such a face has
// more than one local maximum under the order (value, vertex id). Faces with a vertex that has no value are not
// counted. `boundary`: the mesh, or only the boundary faces of the mesh. Reads the cell records of all blocks. Throws
// Error when `values` has another size.
[[nodiscard]] std::uint64_t count_ambiguous_faces(const Topology& topology, const FaceMeshView& boundary,
                                                  ValuesView values);

} // namespace ciel
