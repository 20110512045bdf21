// What the patches say about the points on them, which is exact where interpolation from cells is not.
#pragma once

#include "import/patches.hpp"

#include <optional>

namespace ciel::importer {

// The values of one array on one patch: one tuple per cell of the patch's surface; nothing when it has none.
using PatchValues = std::optional<std::vector<float>>;

// A vertex takes the area-weighted mean over the patch faces around it. Where patches meet, the strongest kind wins:
// 1. no-slip walls (`no_slip`, the same for all arrays), 2. patches that hold one value (fixed values), 3. the rest;
// patches of one kind are averaged.
class WallValues {
public:
    WallValues(const FaceMeshView& mesh, const std::vector<Patch>& patches);

    // `values` and `no_slip` per patch; `points`: components values per stored vertex, overwritten on the patches.
    void overlay(const std::vector<PatchValues>& values, const std::vector<bool>& no_slip, int components,
                 std::span<float> points) const;

private:
    struct Entry {
        Index vertex;     // index into vertices_
        std::size_t cell; // of the patch's surface
        double area;
    };
    std::vector<Index> vertices_;             // stored vertices on patches
    std::vector<std::vector<Entry>> entries_; // per patch
};

// A patch on which a velocity-like vector is zero everywhere.
[[nodiscard]] bool holds_only_zero(const std::vector<float>& values);

} // namespace ciel::importer
