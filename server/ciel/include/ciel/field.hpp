// A scalar field on the vertices as the kernel reads it: values in block order, [min, max] per block, gradients on
// demand. Also the quantities derived from a field (paper: slices, section 2.1; minima, section 2.2; gradients, section
// 3).
#pragma once

#include "ciel/array_view.hpp"
#include "ciel/mesh.hpp"

#include <memory>
#include <span>
#include <vector>

namespace ciel {

class GeometricVertices; // geometric_vertices.hpp

// Immutable except for caches that are made on demand, each under its own lock: values in block order, ranges of cells,
// the sorted extrema and the gradients. Copies share everything. Thread-safe, except set_direction and vertices_moved.
class Field {
public:
    // values: one number per point of the mesh, in the caller's order; copied as floats. NaN and infinities mean "no
    // value here": a cell that touches such a point is not cut, and adds nothing to gradients. Throws Error on another
    // number of values. Keeps the mesh alive.
    Field(const Mesh& mesh, const ArrayView& values);
    // From one number per cell. Point values are weighted means of the cells around the point, exact for linear fields
    // where the cells surround it (point_interpolation.hpp). Throws Error on another number of values.
    [[nodiscard]] static Field from_cells(const Mesh& mesh, const ArrayView& values);
    // The distance from the plane through `origin` perpendicular to `normal`, which has unit length. The surface at 0
    // is a slice.
    [[nodiscard]] static Field plane(const Mesh& mesh, const Vec3d& origin, const Vec3d& normal);
    // Values in stored order, without a copy. `keep_alive` owns the values, which must not change while the field
    // lives. The topology must outlive the field. Throws Error on another number of values.
    Field(const Topology& topology, std::span<const float> values, std::shared_ptr<const void> keep_alive);
    ~Field();
    Field(const Field&);
    Field& operator=(const Field&);
    Field(Field&&) noexcept;
    Field& operator=(Field&&) noexcept;

    [[nodiscard]] const Mesh* mesh() const; // the field's mesh; null if made from a topology
    [[nodiscard]] std::span<const float> values() const;
    [[nodiscard]] std::array<float, 2> range() const; // finite values only; {0, 0} when there are none

    // Strict local minima under the order (value, vertex id), sorted in that order (paper, section 2.2). Vertices
    // without a value are neither minima nor neighbours.
    [[nodiscard]] std::span<const Index> sorted_minima() const;

    // States that the values are plane_distance(mesh, ., normal) on the mesh of `where`. Extrema are then searched only
    // at the vertices of `where`. Call it before any other use of the field.
    void set_direction(std::shared_ptr<const GeometricVertices> where, Vec3d normal);

    // Copies the values of all blocks into block order now. Without this call each block is copied at its first use.
    // Uses all threads.
    void take_in() const;

    // Drops the cached gradients, which depend on positions. Must not run during an extraction from this field.
    void vertices_moved();

    struct Data; // for the kernel's own files
    [[nodiscard]] const Data& data() const { return *data_; }

private:
    Field(const Mesh& mesh, const std::shared_ptr<const std::vector<float>>& stored);
    std::shared_ptr<Data> data_;
};

// Returns nu = dot(normal, position - origin) per vertex; origin is in world coordinates, as are positions. For
// box-aligned and free slices (paper, section 2.1).
[[nodiscard]] std::vector<float> plane_distance(const FaceMeshView& mesh, Vec3d origin, Vec3d normal);

// Least-squares gradient per polyhedron, volume-weighted average at the vertices (paper, section 3); centred, in
// double. Zero where no cell around a vertex has both a volume and all its values.
[[nodiscard]] std::vector<Vec3f> vertex_gradients(const FaceMeshView& mesh, std::span<const float> values);
// The same, with the mesh's existing topology.
[[nodiscard]] std::vector<Vec3f> vertex_gradients(const Topology& topology, const FaceMeshView& mesh,
                                                  std::span<const float> values);

// Returns the number of faces with more than one local maximum around them under the order (value, vertex id) (paper,
// section 4). It does not depend on nu. Faces that touch a vertex without a value do not count. Throws Error unless
// there is one value per vertex.
[[nodiscard]] std::uint64_t count_ambiguous_faces(const FaceMeshView& mesh, std::span<const float> values);

} // namespace ciel
