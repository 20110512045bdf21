// What the patches say about the points on them, which is exact where interpolation from cells is not.
#pragma once

#include "import/mesh/patches.hpp"
#include "import/values/patch_weights.hpp"

#include <optional>
#include <span>

namespace ciel::importer {

// The values of one array on one patch: one tuple per cell of the patch's surface; nothing when it has none.
using PatchValues = std::optional<std::vector<float>>;

enum class PatchRole : std::uint8_t {
    no_slip_wall, // a velocity-like vector is zero on it; the same for all arrays
    other,
    free,  // its values follow from those inside, even where they are all the same
    plane, // vectors lie in it: slip walls, planes of symmetry
};

// A vertex takes the mean over the patch faces around it, with weights that are exact for fields linear along the
// patch. Where patches meet, the strongest kind wins: 1. no-slip walls, 2. patches that hold one value (fixed
// values), 3. the rest; patches of one kind are averaged by area.
class WallValues {
public:
    WallValues(const FaceMeshView& mesh, const std::vector<Patch>& patches);

    // `values` and `roles` per patch; `points`: components values per stored vertex, overwritten on the patches. Three
    // components are a vector.
    void overlay(const std::vector<PatchValues>& values, const std::vector<PatchRole>& roles, int components,
                 std::span<float> points) const;

private:
    struct Entry {
        Index vertex;     // index into vertices_
        std::size_t cell; // of the patch's surface
        double weight;    // sum over a vertex: the area of the faces around it
    };
    struct Plane {
        Index vertex; // index into vertices_
        std::vector<Vec3d> normals;
    };
    void put_into_planes(const std::vector<PatchRole>& roles, const std::vector<std::uint8_t>& kinds,
                         std::span<float> points) const;

    std::vector<Index> vertices_;             // stored vertices on patches
    std::vector<std::vector<Entry>> entries_; // per patch
    std::vector<std::vector<Plane>> planes_;  // per patch
};

// A patch on which a velocity-like vector is zero everywhere.
[[nodiscard]] bool holds_only_zero(const std::vector<float>& values);

} // namespace ciel::importer
