// Batches of polygons back from their messages, by meshoptimizer's decoders and the rules of protocol/frame.md.
#pragma once

#include "ciel/types.hpp"

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace ciel::wire {

struct DecodedBatch {
    nlohmann::json description;
    std::vector<Vec3f> positions, normals;
    std::vector<float> values; // per vertex, triangle, line or point, as the description says
    std::vector<Index> indices;
};

// A client's memory of the parts that batches may name.
class GeometryClient {
public:
    // Throws std::runtime_error where the payload does not fit its description, or names what did not come before.
    [[nodiscard]] DecodedBatch decode(std::span<const std::uint8_t> payload);

private:
    std::map<std::string, DecodedBatch> meshes_;
    std::map<std::string, std::vector<float>> values_;
};

} // namespace ciel::wire
