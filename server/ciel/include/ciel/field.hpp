// A scalar field on the vertices as the kernel reads it: values in block order, [min, max] per block, gradients on
// demand; and what is made of one (paper: slices, section 2.1; minima, section 2.2; gradients, section 3).
#pragma once

#include "ciel/array_view.hpp"
#include "ciel/mesh.hpp"

#include <memory>
#include <span>
#include <vector>

namespace ciel {

class GeometricVertices; // geometric_vertices.hpp

// Immutable but for what is made on demand under locks of its own: values in block order, ranges of cells, the sorted
// extrema and the gradients. Copies share everything. Any thread may use it.
class Field {
public:
    // values: one number per point of the mesh, in the caller's order; copied as floats. NaN and infinities mean "no
    // value here": a cell that touches such a point is not cut, and adds nothing to gradients. Throws Error on another
    // number of values. Keeps the mesh alive.
    Field(const Mesh& mesh, const ArrayView& values);
    // One number per cell: the values of points are means of the cells around them, exact for linear fields where the
    // cells surround the point (point_interpolation.hpp).
    [[nodiscard]] static Field from_cells(const Mesh& mesh, const ArrayView& values);
    // The distance from the plane through `origin` across `normal`, of unit length; a surface at 0 is a slice.
    [[nodiscard]] static Field plane(const Mesh& mesh, const Vec3d& origin, const Vec3d& normal);
    // In stored order, without a copy: `keep_alive` owns the values, which must not change while the field lives, and
    // the topology must outlive it.
    Field(const Topology& topology, std::span<const float> values, std::shared_ptr<const void> keep_alive);
    ~Field();
    Field(const Field&);
    Field& operator=(const Field&);
    Field(Field&&) noexcept;
    Field& operator=(Field&&) noexcept;

    [[nodiscard]] const Mesh* mesh() const; // that it was made from; null where it was made from a topology
    [[nodiscard]] std::span<const float> values() const;
    [[nodiscard]] std::array<float, 2> range() const; // finite values only; {0, 0} when there are none

    // Strict local minima under the order (value, vertex id), sorted by it (paper, section 2.2). Vertices without a
    // value are neither minima nor neighbours.
    [[nodiscard]] std::span<const Index> sorted_minima() const;

    // The values are plane_distance(mesh, ., normal) of the mesh that `where` is of: extrema are looked for only there.
    // Before anybody else uses the field.
    void set_direction(std::shared_ptr<const GeometricVertices> where, Vec3d normal);

    // Puts the values of all blocks in order now; else each block's are at its first use. Uses all threads.
    void take_in() const;

    // Forgets the gradients, which belong to positions. Not while anybody extracts from it.
    void vertices_moved();

    struct Data; // for the kernel's own files
    [[nodiscard]] const Data& data() const { return *data_; }

private:
    Field(const Mesh& mesh, const std::shared_ptr<const std::vector<float>>& stored);
    std::shared_ptr<Data> data_;
};

// nu = dot(normal, position - origin), origin in world coordinates like the positions: box-aligned and free slices
// (paper, section 2.1).
[[nodiscard]] std::vector<float> plane_distance(const FaceMeshView& mesh, Vec3d origin, Vec3d normal);

// Least-squares gradient per polyhedron, volume-weighted average at the vertices (paper, section 3); centred, in
// double. Zero where no cell around a vertex spans a volume or has all its values.
[[nodiscard]] std::vector<Vec3f> vertex_gradients(const FaceMeshView& mesh, std::span<const float> values);
// The same where the mesh's topology is there already.
[[nodiscard]] std::vector<Vec3f> vertex_gradients(const Topology& topology, const FaceMeshView& mesh,
                                                  std::span<const float> values);

// Faces with more than one local maximum around them under the order (value, vertex id) (paper, section 4; whatever
// nu). Faces that touch a vertex without a value do not count.
[[nodiscard]] std::uint64_t count_ambiguous_faces(const FaceMeshView& mesh, std::span<const float> values);

} // namespace ciel
