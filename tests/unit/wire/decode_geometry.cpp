#include "decode_geometry.hpp"

#include "wire/batches/quantize.hpp"

#include <cmath>
#include <cstring>
#include <meshoptimizer.h>
#include <stdexcept>

namespace server::wire {
using namespace ciel;
namespace {

using nlohmann::json;

std::span<const std::uint8_t> take(std::span<const std::uint8_t>& bytes, std::size_t count) {
    if (bytes.size() < count) throw std::runtime_error("the batch is shorter than it says");
    const auto taken = bytes.first(count);
    bytes = bytes.subspan(count);
    return taken;
}

void check(int failed, const char* what) {
    if (failed != 0) throw std::runtime_error(std::string(what) + " cannot be decoded");
}

template <typename Record>
std::vector<Record> records(std::span<const std::uint8_t> bytes, std::size_t count) {
    std::vector<Record> out(count);
    check(meshopt_decodeVertexBuffer(out.data(), count, sizeof(Record), bytes.data(), bytes.size()), "a vertex stream");
    return out;
}

struct Place {
    std::array<std::uint32_t, 3> at;
};
struct PlaceAndNormal {
    std::array<std::uint32_t, 3> at;
    std::array<std::int8_t, 2> normal;
    std::array<std::int8_t, 2> unused;
};

Vec3f position(const json& mesh, const std::array<std::uint32_t, 3>& at) {
    Vec3f out{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        out[axis] = static_cast<float>((mesh["low"][axis].get<double>() + at[axis]) * mesh["step"].get<double>());
    return out;
}

DecodedBatch decode_mesh(const json& description, std::span<const std::uint8_t>& rest) {
    DecodedBatch out;
    const json& mesh = description["mesh"];
    const std::size_t vertices = description["vertices"];
    const auto bytes = take(rest, mesh["bytes"][0]);
    if (description["normals"]) {
        for (const auto& record : records<PlaceAndNormal>(bytes, vertices)) {
            out.positions.push_back(position(mesh, record.at));
            out.normals.push_back(from_octahedral(record.normal));
        }
    } else {
        for (const auto& record : records<Place>(bytes, vertices)) out.positions.push_back(position(mesh, record.at));
    }
    out.indices.resize(description["indices"]);
    const auto corners = take(rest, mesh["bytes"][1]);
    if (description["kind"] == "triangles")
        check(meshopt_decodeIndexBuffer(out.indices.data(), out.indices.size(), corners.data(), corners.size()),
              "triangles");
    else
        check(meshopt_decodeIndexSequence(out.indices.data(), out.indices.size(), corners.data(), corners.size()),
              "indices");
    return out;
}

std::vector<double> decode_values(const json& description, std::span<const std::uint8_t>& rest) {
    const json& values = description["values"];
    const std::size_t corners = description["kind"] == "triangles" ? 3 : description["kind"] == "lines" ? 2 : 1;
    const std::size_t count = values["of"] == "vertices" ? description["vertices"].get<std::size_t>()
                                                         : description["indices"].get<std::size_t>() / corners;
    const auto bytes = take(rest, values["bytes"]);
    std::vector<double> out;
    if (!values.contains("step")) {
        const std::vector<float> floats = records<float>(bytes, count);
        out.assign(floats.begin(), floats.end());
        return out;
    }
    for (const std::uint32_t place : records<std::uint32_t>(bytes, count))
        out.push_back(place == no_value ? NAN
                                        : values["origin"].get<double>() +
                                              values["step"].get<double>() * (values["low"].get<double>() + place));
    return out;
}

} // namespace

DecodedBatch GeometryClient::decode(std::span<const std::uint8_t> payload) {
    std::uint32_t json_bytes = 0;
    std::memcpy(&json_bytes, take(payload, 4).data(), 4);
    const auto text = take(payload, json_bytes);
    json description = json::parse(text.begin(), text.end());
    DecodedBatch out;
    if (description["batches"] != 0) {
        const json& mesh = description["mesh"];
        if (mesh.contains("bytes")) meshes_[mesh["id"]] = decode_mesh(description, payload);
        out = meshes_.at(mesh["id"]);
        if (description.contains("values")) {
            const json& values = description["values"];
            if (values.contains("bytes")) values_[values["id"]] = decode_values(description, payload);
            out.values = values_.at(values["id"]);
        }
    }
    if (!payload.empty()) throw std::runtime_error("the batch is longer than it says");
    out.description = std::move(description);
    return out;
}

} // namespace server::wire
