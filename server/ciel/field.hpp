// A scalar field on the vertices as the kernel reads it: values in block order, [min, max] per block, gradients on
// demand; and what is made of one (paper: slices, section 2.1; minima, section 2.2; gradients, section 3).
#pragma once

#include "ciel/topology.hpp"

#include <memory>
#include <span>
#include <vector>

namespace ciel {

class GeometricVertices; // geometric_vertices.hpp

// Shared by sessions; immutable but for what is made on demand under locks of its own: values in block order, ranges of
// cells, the sorted extrema and the gradients (so a field is used with one set of positions at a time). Keeps the
// values alive through `keep_alive`, which must not change while it lives, and the topology by reference: it must not
// outlive the topology. Any thread may use it.
class Field {
public:
    // values: one per stored vertex; throws Error on another length. NaN and infinities mean "no value here": a cell
    // that touches such a vertex is not cut, and adds nothing to gradients.
    Field(const Topology& topology, std::span<const float> values, std::shared_ptr<const void> keep_alive);
    ~Field();
    Field(Field&&) noexcept;
    Field& operator=(Field&&) noexcept;

    [[nodiscard]] std::span<const float> values() const;
    [[nodiscard]] std::array<float, 2> range() const; // finite values only; {0, 0} when there are none

    // Strict local minima under the order (value, vertex id), sorted by it (paper, section 2.2). Vertices without a
    // value are neither minima nor neighbours.
    [[nodiscard]] std::span<const Index> sorted_minima() const;

    // The values are plane_distance(mesh, ., normal) of the mesh that `where` is of: extrema are looked for only there.
    // Before anybody else uses the field.
    void set_direction(std::shared_ptr<const GeometricVertices> where, Vec3d normal);

    // Forgets the gradients, which belong to positions. Not while anybody extracts from it.
    void vertices_moved();

    struct Blocks;
    [[nodiscard]] const Blocks& blocks() const { return *blocks_; }

private:
    std::unique_ptr<Blocks> blocks_;
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
