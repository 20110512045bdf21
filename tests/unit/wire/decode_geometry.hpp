// Decodes geometry batches with meshoptimizer's decoders and the rules of protocol/frame.md.
#pragma once

#include "ciel/types.hpp"

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace server::wire {
using namespace ciel;

struct DecodedBatch {
    nlohmann::json description;
    std::vector<Vec3f> positions, normals;
    std::vector<double> values; // one per vertex, triangle, line or point; the description says which
    std::vector<Index> indices;
};

// A client that keeps the meshes that later batches refer to.
class GeometryClient {
public:
    // Throws std::runtime_error when the payload does not fit its description or refers to an unknown mesh.
    [[nodiscard]] DecodedBatch decode(std::span<const std::uint8_t> payload);

private:
    std::map<std::string, DecodedBatch> meshes_;
    std::map<std::string, std::vector<double>> values_;
};

} // namespace server::wire
