// Replaces interpolated values at points on patches by the solver's values there, which are more accurate.
#pragma once

#include "import/mesh/patches.hpp"
#include "import/values/patch_weights.hpp"

#include <optional>
#include <span>

namespace ciel::importer {

// The values of one array on one patch: one tuple per cell of the patch's surface; nullopt if it has none.
using PatchValues = std::optional<store::Values>;

enum class PatchRole : std::uint8_t {
    no_slip_wall, // a vector such as the velocity is zero on the patch; the role holds for all arrays
    other,
    free,  // values follow from the interior (zeroGradient), even if they are constant
    plane, // vectors are tangential: slip walls, planes of symmetry
};

// A vertex takes the mean over the patch faces around it, with weights that are exact for fields linear along the
// patch. Where patches meet, the strongest kind wins: 1. no-slip walls, 2. patches that hold one value (fixed
// values), 3. the rest; patches of one kind are averaged by area.
class WallValues {
public:
    WallValues(const FaceMeshView& mesh, const std::vector<Patch>& patches);

    // `values`, `roles`: one per patch. `points`: `components` values per stored vertex; those on patches with values
    // are overwritten. Arrays of three components are vectors.
    // T: float or double.
    template <class T>
    void overlay(const std::vector<PatchValues>& values, const std::vector<PatchRole>& roles, int components,
                 std::vector<T>& points) const;

private:
    struct Entry {
        Index vertex;     // index into vertices_
        std::size_t cell; // cell id in the patch's surface
        double weight;    // the weights of a vertex sum to the area of its patch faces
    };
    struct Plane {
        Index vertex; // index into vertices_
        std::vector<Vec3d> normals;
    };
    template <class T>
    void put_into_planes(const std::vector<PatchRole>& roles, const std::vector<std::uint8_t>& kinds,
                         std::vector<T>& points) const;

    std::vector<Index> vertices_;             // stored vertices on patches
    std::vector<std::vector<Entry>> entries_; // per patch
    std::vector<std::vector<Plane>> planes_;  // per patch
};

// Returns whether all values are zero and there is at least one.
[[nodiscard]] bool holds_only_zero(ValuesView values);

} // namespace ciel::importer
