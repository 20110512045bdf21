// Polygon batches: the payloads of kind 2 (protocol/frame.md).
#pragma once

#include "ciel/types.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ciel::wire {

// Triangles, lines or points of one layer; borrowed. Range and colour are finite.
struct GeometryMesh {
    std::string layer; // id in the scene
    std::span<const Vec3f> positions, normals;
    std::span<const float> scalars;
    std::span<const Index> indices; // 3 per triangle, 2 per line, 1 per point
    bool lines = false, points = false;
    std::string map;
    std::array<float, 2> range{0, 1};
    std::array<float, 4> color{};
    bool lit = true;
    float line_width = 1.5F;                    // pixels
    std::span<const std::array<float, 4>> clip; // (normal, offset): shown where dot(normal, position) + offset >= 0
    std::string scale = "{}";                   // a JSON object: what protocol/frame.md says of `scale`
};

inline constexpr std::size_t batch_vertices = 65536; // so that 16-bit indices reach every vertex

// One payload per batch, in drawing order; a single one with "batches": 0 when there is nothing to show. Every batch is
// self-contained: its indices count within it, and a vertex that two batches use is in both. Consecutive triangles stay
// together, so a batch is a run of blocks. Throws Error when arrays do not fit together.
[[nodiscard]] std::vector<std::vector<std::uint8_t>> encode_geometry(std::span<const GeometryMesh> meshes, Vec3d origin,
                                                                     std::size_t max_vertices = batch_vertices);

} // namespace ciel::wire
