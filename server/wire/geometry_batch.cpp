#include "wire/geometry_batch.hpp"

#include "wire/bytes.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace ciel::wire {
namespace {

struct Batch {
    const GeometryMesh* mesh = nullptr;
    std::vector<Index> vertices; // of the mesh, in order of first use
    std::vector<Index> indices;  // into `vertices`
};

std::size_t corners_of(const GeometryMesh& mesh) { return mesh.points ? 1 : mesh.lines ? 2 : 3; }

void check(const GeometryMesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    const bool fits = (mesh.normals.empty() || mesh.normals.size() == vertices) &&
                      (mesh.scalars.empty() || mesh.scalars.size() == vertices) &&
                      mesh.indices.size() % corners_of(mesh) == 0 &&
                      std::all_of(mesh.indices.begin(), mesh.indices.end(), [&](Index v) { return v < vertices; });
    if (!fits) throw Error("the arrays of layer '" + mesh.layer + "' do not fit together and cannot be sent");
}

// Cuts the mesh where the next triangle or line would be one vertex too many.
void split(const GeometryMesh& mesh, std::size_t max_vertices, std::vector<Batch>& batches) {
    const std::size_t corners = corners_of(mesh);
    std::vector<Index> local(mesh.positions.size(), none); // valid when the batch's vertex there is this one
    Batch batch{&mesh, {}, {}};
    const auto is_known = [&](Index vertex) {
        return local[vertex] < batch.vertices.size() && batch.vertices[local[vertex]] == vertex;
    };
    for (std::size_t i = 0; i < mesh.indices.size(); i += corners) {
        const auto primitive = mesh.indices.subspan(i, corners);
        const auto added = static_cast<std::size_t>(
            std::count_if(primitive.begin(), primitive.end(), [&](Index vertex) { return !is_known(vertex); }));
        if (batch.vertices.size() + added > max_vertices && !batch.vertices.empty()) {
            batches.push_back(std::move(batch));
            batch = {&mesh, {}, {}};
        }
        for (const Index vertex : primitive) {
            if (!is_known(vertex)) {
                local[vertex] = static_cast<Index>(batch.vertices.size());
                batch.vertices.push_back(vertex);
            }
            batch.indices.push_back(local[vertex]);
        }
    }
    if (!batch.indices.empty()) batches.push_back(std::move(batch));
}

void append_number(std::string& json, double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    json.append(digits.data(), end);
}

template <typename Items, typename Append>
void append_list(std::string& json, const Items& items, Append append_one) {
    json += '[';
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0) json += ", ";
        append_one(items[i]);
    }
    json += ']';
}

template <typename Numbers>
void append_array(std::string& json, const Numbers& numbers) {
    append_list(json, numbers, [&](double number) { append_number(json, number); });
}

void append_string(std::string& json, std::string_view text) {
    constexpr std::string_view hex = "0123456789abcdef";
    json += '"';
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            json += '\\';
            json += c;
        } else if (code < 0x20) {
            json += "\\u00";
            json += hex[code >> 4U];
            json += hex[code & 15U];
        } else {
            json += c;
        }
    }
    json += '"';
}

const char* name_of(bool value) { return value ? "true" : "false"; }

std::string description(const GeometryMesh& mesh, const Batch& batch, Vec3d origin, std::size_t number,
                        std::size_t batches) {
    std::string json = "{\"layer\": ";
    append_string(json, mesh.layer);
    json += std::string(", \"kind\": \"") + (mesh.points ? "points" : mesh.lines ? "lines" : "triangles") + "\"";
    json += ", \"vertices\": " + std::to_string(batch.vertices.size());
    json += ", \"indices\": " + std::to_string(batch.indices.size());
    json += std::string(", \"normals\": ") + name_of(!mesh.normals.empty());
    json += std::string(", \"scalars\": ") + name_of(!mesh.scalars.empty());
    json += ", \"map\": ";
    append_string(json, mesh.map);
    json += ", \"range\": ";
    append_array(json, mesh.range);
    json += ", \"scale\": " + mesh.scale + ", \"color\": ";
    append_array(json, mesh.color);
    json += std::string(", \"lit\": ") + name_of(mesh.lit);
    if (mesh.lines || mesh.points) {
        json += ", \"width\": ";
        append_number(json, mesh.line_width);
    }
    if (!mesh.clip.empty()) {
        json += ", \"clip\": ";
        append_list(json, mesh.clip, [&](const auto& plane) { append_array(json, plane); });
    }
    json += ", \"origin\": ";
    append_array(json, origin);
    json += ", \"batch\": " + std::to_string(number) + ", \"batches\": " + std::to_string(batches) + "}";
    json.resize((json.size() + 3) / 4 * 4, ' '); // so that the arrays behind it are aligned
    return json;
}

template <typename T>
void append_gathered(std::vector<std::uint8_t>& out, std::span<const T> values, const std::vector<Index>& vertices) {
    const std::size_t begin = out.size();
    out.resize(begin + vertices.size() * sizeof(T));
    std::uint8_t* at = out.data() + begin;
    for (const Index vertex : vertices) {
        std::memcpy(at, &values[vertex], sizeof(T));
        at += sizeof(T);
    }
}

std::vector<std::uint8_t> encode(const Batch& batch, Vec3d origin, std::size_t number, std::size_t batches) {
    const GeometryMesh& mesh = *batch.mesh;
    const std::string json = description(mesh, batch, origin, number, batches);
    const std::size_t per_vertex = 12 + (mesh.normals.empty() ? 0 : 12) + (mesh.scalars.empty() ? 0 : 4);
    std::vector<std::uint8_t> out(4);
    out.reserve(4 + json.size() + per_vertex * batch.vertices.size() + 4 * batch.indices.size());
    put(out.data(), static_cast<std::uint32_t>(json.size()));
    out.insert(out.end(), json.begin(), json.end());
    append_gathered(out, mesh.positions, batch.vertices);
    if (!mesh.normals.empty()) append_gathered(out, mesh.normals, batch.vertices);
    if (!mesh.scalars.empty()) append_gathered(out, mesh.scalars, batch.vertices);
    append(out, std::span<const Index>(batch.indices));
    return out;
}

} // namespace

std::vector<std::vector<std::uint8_t>> encode_geometry(std::span<const GeometryMesh> meshes, Vec3d origin,
                                                       std::size_t max_vertices) {
    std::vector<Batch> batches;
    for (const GeometryMesh& mesh : meshes) {
        check(mesh);
        split(mesh, max_vertices, batches);
    }
    std::vector<std::vector<std::uint8_t>> payloads;
    payloads.reserve(batches.size());
    for (const Batch& batch : batches) payloads.push_back(encode(batch, origin, payloads.size(), batches.size()));
    if (batches.empty()) {
        const GeometryMesh nothing;
        payloads.push_back(encode({&nothing, {}, {}}, origin, 0, 0));
    }
    return payloads;
}

} // namespace ciel::wire
