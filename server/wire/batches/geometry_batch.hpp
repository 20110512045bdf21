// Polygon batches: the payloads of kind 2 (protocol/frame.md).
#pragma once

#include "ciel/types.hpp"
#include "ciel/values_view.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

namespace server::wire {

// Triangles, lines or points of one layer. Does not own the arrays. `range` and `color` must be finite.
struct Primitives {
    std::string layer; // id in the scene
    std::span<const ciel::Vec3f> positions, normals;
    ciel::ValuesView scalars; // one per vertex; empty if there are `values`
    ciel::ValuesView values;  // one per triangle, line or point; empty if there are `scalars`
    // Step to which scalars or values are rounded; the error is at most half a step. 0: they are sent as floats.
    double value_step = 0;
    std::span<const ciel::Index> indices; // 3 per triangle, 2 per line, 1 per point
    bool lines = false, points = false;
    std::string map;
    std::array<double, 2> range{0, 1};
    std::array<float, 4> color{};
    bool lit = true;
    float line_width = 1.5F; // pixels
    // Planes (normal, offset). Points with dot(normal, position) + offset >= 0 are shown.
    std::span<const std::array<float, 4>> clip;
    std::string scale = "{}"; // JSON object, the member `scale` of protocol/frame.md
};

inline constexpr std::size_t batch_vertices = 65536;

using ArrayIds = std::unordered_set<std::uint64_t>; // content hashes of the arrays of batches

struct HeldArrays {
    std::uint32_t base = 0; // last acknowledged frame; 0 if there is none
    ArrayIds ids;           // arrays of frame `base`
};

struct EncodedGeometry {
    std::vector<std::vector<std::uint8_t>> payloads; // one per batch, in drawing order
    ArrayIds ids;                                    // arrays of all batches, sent or already held
};

// Returns one payload per batch; without batches, a single payload with "batches": 0. Vertices shared between batches
// are repeated with the same grid position. Triangles keep their order. An array in `held` is sent as its id only.
// `step`: grid step in length units, a power of two (quantize.hpp). Throws Error if sizes or indices do not fit.
[[nodiscard]] EncodedGeometry encode_geometry(std::span<const Primitives> all, ciel::Vec3d origin, double step,
                                              const HeldArrays& held = {}, std::size_t max_vertices = batch_vertices);

} // namespace server::wire
