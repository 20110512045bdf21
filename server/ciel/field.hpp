// A scalar field on the vertices as the kernel reads it: values in block order, [min, max] per block, gradients on
// demand.
#pragma once

#include "ciel/topology.hpp"

#include <memory>
#include <span>

namespace ciel {

// Shared by sessions; immutable but for the lazily made gradients, which are made under a lock of its own. Keeps the
// values alive through `keep_alive` and the topology by reference: it must not outlive the topology.
class Field {
public:
    // values: one per stored vertex. NaN means "no value here": a polygon is never drawn through a NaN vertex.
    Field(const Topology& topology, std::span<const float> values, std::shared_ptr<const void> keep_alive);
    ~Field();
    Field(Field&&) noexcept;
    Field& operator=(Field&&) noexcept;

    [[nodiscard]] std::span<const float> values() const;
    [[nodiscard]] std::array<float, 2> range() const; // finite values only; {0, 0} when there are none

    // Strict local minima under the order (value, vertex id), sorted (paper, section 2.2).
    [[nodiscard]] std::span<const Index> sorted_minima() const;

    struct Blocks;
    [[nodiscard]] const Blocks& blocks() const { return *blocks_; }

private:
    std::unique_ptr<Blocks> blocks_;
};

// nu = dot(normal, position): box-aligned and free slices (paper, section 2.1).
[[nodiscard]] std::vector<float> plane_distance(const FaceMeshView& mesh, Vec3d origin, Vec3d normal);

// Least-squares gradient per polyhedron, volume-weighted average at the vertices (paper, section 3); centred, in
// double.
[[nodiscard]] std::vector<Vec3f> vertex_gradients(const FaceMeshView& mesh, std::span<const float> values);

// Faces with more than one local maximum around them (paper, section 4; whatever nu).
[[nodiscard]] std::uint64_t count_ambiguous_faces(const FaceMeshView& mesh, std::span<const float> values);

} // namespace ciel
