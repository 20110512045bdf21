// One mesh's directory, written.
#pragma once

#include "store/format/attributes.hpp"
#include "store/format/zarr_array.hpp"
#include "store/writer.hpp"

namespace ciel::store {

// Everything under `directory` but the values; the attributes' checksums are filled in. Throws Error when an array has
// a wrong size, a group an id out of range, or a coordinate is not finite.
[[nodiscard]] MeshAttributes write_mesh(const std::filesystem::path& directory, const FaceMesh& mesh,
                                        std::span<const Index> original_vertex, std::span<const Index> original_cell,
                                        std::span<const NamedGroup> groups, const SolverIds& solver);

void check_finite(std::span<const float> positions);

// The shape of a mesh's coordinate sets, and of an array with this many steps.
[[nodiscard]] ZarrArray positions_shape(std::uint64_t sets, std::uint64_t vertices);
[[nodiscard]] ZarrArray values_shape(std::uint64_t steps, std::uint64_t items, int components);

} // namespace ciel::store
