// A test mesh that has gone through the kernel's front door, with the way back to the ids of the input.
#pragma once

#include "ciel/extract.hpp"
#include "oracle/twin/twin.hpp"
#include "support/views.hpp"

namespace ciel::test {

struct KernelMesh {
    explicit KernelMesh(const Polyhedra& mesh, Topology::Options options = {})
        : assembled(assemble(view(mesh))), topology(assembled.mesh.view(), options) {}

    Assembled assembled;
    Topology topology;

    [[nodiscard]] FaceMeshView mesh() const { return assembled.mesh.view(); }
    [[nodiscard]] Query query(Algorithm algorithm = Algorithm::signatures) const {
        return {topology, mesh(), algorithm};
    }
    // Values of the input's vertices in stored order.
    [[nodiscard]] std::vector<float> stored(std::span<const float> input_values) const;
    [[nodiscard]] Cut cut(const Surface& surface) const; // in ids of the input
};

// A field that keeps its own values.
[[nodiscard]] Field make_field(const Topology& topology, std::vector<float> stored_values);

// Empty when the surface keeps what its header promises, whatever the field; otherwise one line.
[[nodiscard]] std::string broken_promise(const Surface& surface, const KernelMesh& mesh, std::span<const float> stored,
                                         double nu, bool normals);

// Empty when all arrays (of chunks only if asked) are the same bits; otherwise the name of the first that is not.
enum class Chunks { compare, ignore };
[[nodiscard]] std::string bit_difference(const Surface& a, const Surface& b, Chunks chunks = Chunks::compare);

[[nodiscard]] Vec3d vector_area(std::span<const Vec3f> positions, std::span<const Index> polygon);
[[nodiscard]] std::span<const Index> polygon(const Surface& surface, std::size_t index);

} // namespace ciel::test
