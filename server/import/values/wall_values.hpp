// At points on patches, replaces the values interpolated from cells by the solver's values on the patches, which are
// more accurate.
#pragma once

#include "import/mesh/patches.hpp"
#include "import/values/patch_weights.hpp"

#include <optional>
#include <span>

namespace server::importer {

// One tuple per cell of the patch's surface; nullopt if the patch has no values.
using PatchValues = std::optional<store::Values>;

enum class PatchRole : std::uint8_t {
    no_slip_wall, // a vector such as the velocity is zero on the patch; the role holds for all arrays
    other,
    free,  // values come from the interior (zeroGradient); even constant values are not fixed values
    plane, // vectors are tangential: slip walls, planes of symmetry
};

// A vertex gets a weighted mean of the values on the patch faces around the vertex. The weights are exact for fields
// that are linear along the patch. Where patches meet, only the patches of the first kind in this list are used:
// 1. no-slip walls,
// 2. patches of the role `other` with one constant value (fixed values),
// 3. other patches.
// Patches of the same kind are averaged by area.
class WallValues {
public:
    WallValues(const ciel::FaceMeshView& mesh, const std::vector<Patch>& patches);

    // `values`, `roles`: one per patch. `points`: `components` values per vertex of the mesh. Overwrites the values at
    // vertices on patches with values. Arrays of three components are vectors. T: float or double.
    template <class T>
    void overlay(const std::vector<PatchValues>& values, const std::vector<PatchRole>& roles, int components,
                 std::span<T> points) const;

private:
    struct Entry {
        ciel::Index vertex; // index into vertices_
        std::size_t cell;   // cell id in the patch's surface
        double weight;      // the weights of a vertex sum to the area of the patch's faces around it
    };
    struct WallPlane {
        ciel::Index vertex; // index into vertices_
        std::vector<ciel::Vec3d> normals;
    };
    template <class T>
    void put_into_planes(const std::vector<PatchRole>& roles, const std::vector<std::uint8_t>& kinds,
                         std::span<T> points) const;

    std::vector<ciel::Index> vertices_;          // ids of the vertices on patches
    std::vector<std::vector<Entry>> entries_;    // per patch
    std::vector<std::vector<WallPlane>> planes_; // per patch
};

[[nodiscard]] bool holds_only_zero(ciel::ValuesView values);

} // namespace server::importer
