// A test mesh assembled by the kernel, with conversions to and from the ids of the input.
#pragma once

#include "ciel/extract.hpp"
#include "oracle/twin/twin.hpp"
#include "support/kept.hpp"
#include "support/views.hpp"

namespace ciel::test {

struct KernelMesh {
    explicit KernelMesh(const Polyhedra& mesh, Topology::Options options = {})
        : assembled(assemble(view(mesh))), topology(assembled.mesh.view(), options) {}

    Assembled assembled;
    Topology topology;

    [[nodiscard]] FaceMeshView mesh() const { return kept(assembled.mesh.view()); }
    [[nodiscard]] Query query(Algorithm algorithm = Algorithm::signatures) const {
        return {topology, mesh(), algorithm};
    }
    // Reorders values of the input's vertices into the kernel's order.
    [[nodiscard]] std::vector<float> stored(std::span<const float> input_values) const;
    [[nodiscard]] Cut cut(const Surface& surface) const; // ids are those of the input
};

// The field owns its values.
[[nodiscard]] Field make_field(const Topology& topology, std::vector<float> stored_values);

// Returns an empty string when the surface fulfills the contract of its header; otherwise a description of the
// violation.
[[nodiscard]] std::string broken_promise(const Surface& surface, const KernelMesh& mesh, std::span<const float> stored,
                                         double nu, bool normals);

// Returns an empty string when all arrays are bit-identical; otherwise the name of the first that differs. `chunks`:
// whether the chunk arrays are compared too.
enum class Chunks { compare, ignore };
[[nodiscard]] std::string bit_difference(const Surface& a, const Surface& b, Chunks chunks = Chunks::compare);

// Returns the surface without the polygons of the other blocks, and without the points that no polygon uses any more.
// `blocks`: ascending.
[[nodiscard]] Surface only(const Surface& all, const std::vector<Index>& blocks);

[[nodiscard]] Vec3d vector_area(std::span<const Vec3f> positions, std::span<const Index> polygon);
[[nodiscard]] std::span<const Index> polygon(const Surface& surface, std::size_t index);

} // namespace ciel::test
