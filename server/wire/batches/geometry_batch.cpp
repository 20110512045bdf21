#include "wire/batches/geometry_batch.hpp"

#include "wire/batches/mesh_codec.hpp"
#include "wire/batches/quantize.hpp"
#include "wire/bytes.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <xxhash.h>

namespace server::wire {
namespace {

struct Batch {
    const Primitives* primitives = nullptr;
    std::size_t first = 0;             // index of the batch's first triangle, line or point in `primitives`
    std::vector<ciel::Index> vertices; // indices into the vertices of `primitives`, in order of first use
    std::vector<ciel::Index> indices;  // indices into `vertices`
};

struct Quantized {
    std::uint64_t id = 0;
    std::vector<std::uint8_t> bytes; // records, one per vertex or value
    std::size_t stride = 4;
    std::array<std::int64_t, 3> low{}; // smallest coordinate per axis, in grid steps; values use low[0] only
};

std::size_t corners_of(const Primitives& primitives) { return primitives.points ? 1 : primitives.lines ? 2 : 3; }

void check(const Primitives& primitives) {
    const std::size_t vertices = primitives.positions.size();
    const bool fits =
        (primitives.normals.empty() || primitives.normals.size() == vertices) &&
        (primitives.scalars.empty() || primitives.scalars.size() == vertices) &&
        (primitives.values.empty() ||
         (primitives.scalars.empty() &&
          primitives.values.size() * corners_of(primitives) == primitives.indices.size())) &&
        primitives.indices.size() % corners_of(primitives) == 0 &&
        std::all_of(primitives.indices.begin(), primitives.indices.end(), [&](ciel::Index v) { return v < vertices; });
    if (!fits) throw ciel::Error("the arrays of layer '" + primitives.layer + "' do not match and cannot be sent");
}

void split(const Primitives& primitives, std::size_t max_vertices, std::vector<Batch>& batches) {
    const std::size_t corners = corners_of(primitives);
    // Index of each vertex in batch.vertices. Valid only if batch.vertices holds the vertex at that index.
    std::vector<ciel::Index> local(primitives.positions.size(), ciel::none);
    Batch batch{&primitives, 0, {}, {}};
    const auto is_known = [&](ciel::Index vertex) {
        return local[vertex] < batch.vertices.size() && batch.vertices[local[vertex]] == vertex;
    };
    for (std::size_t i = 0; i < primitives.indices.size(); i += corners) {
        const auto primitive = primitives.indices.subspan(i, corners);
        const auto added = static_cast<std::size_t>(
            std::count_if(primitive.begin(), primitive.end(), [&](ciel::Index vertex) { return !is_known(vertex); }));
        if (batch.vertices.size() + added > max_vertices && !batch.vertices.empty()) {
            batches.push_back(std::move(batch));
            batch = {&primitives, i / corners, {}, {}};
        }
        for (const ciel::Index vertex : primitive) {
            if (!is_known(vertex)) {
                local[vertex] = static_cast<ciel::Index>(batch.vertices.size());
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

// A record has 12 bytes for the grid position minus `low`, and with normals 4 more, of which 2 are unused.
Quantized shape_array(const Batch& batch, double step) {
    const Primitives& primitives = *batch.primitives;
    Quantized array;
    array.stride = primitives.normals.empty() ? 12 : 16;
    std::vector<std::array<std::int32_t, 3>> places;
    places.reserve(batch.vertices.size());
    std::array<std::int32_t, 3> low{INT32_MAX, INT32_MAX, INT32_MAX};
    for (const ciel::Index vertex : batch.vertices) {
        auto& place = places.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            place[axis] = on_grid(primitives.positions[vertex][axis], 1 / step);
            low[axis] = std::min(low[axis], place[axis]);
        }
    }
    array.low = {low[0], low[1], low[2]};
    array.bytes.resize(places.size() * array.stride);
    std::uint8_t* at = array.bytes.data();
    for (std::size_t i = 0; i < places.size(); ++i, at += array.stride) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            put(at + 4 * axis, static_cast<std::uint32_t>(places[i][axis] - low[axis]));
        if (primitives.normals.empty()) continue;
        const auto normal = octahedral(primitives.normals[batch.vertices[i]]);
        std::memcpy(at + 12, normal.data(), normal.size());
    }
    const XXH64_hash_t vertices = XXH3_64bits(array.bytes.data(), array.bytes.size());
    const std::array<double, 6> rest{step,           double(low[0]),       double(low[1]),
                                     double(low[2]), double(array.stride), double(corners_of(primitives))};
    array.id = XXH3_64bits_withSeed(rest.data(), sizeof rest,
                                    XXH3_64bits_withSeed(batch.indices.data(), 4 * batch.indices.size(), vertices));
    return array;
}

bool has_values(const Primitives& primitives) { return !primitives.scalars.empty() || !primitives.values.empty(); }

Quantized values_array(const Batch& batch) {
    const Primitives& primitives = *batch.primitives;
    std::vector<double> values;
    if (!primitives.scalars.empty()) {
        values.reserve(batch.vertices.size());
        for (const ciel::Index vertex : batch.vertices) values.push_back(primitives.scalars[vertex]);
    } else if (!primitives.values.empty()) {
        const auto own = primitives.values.subview(batch.first, batch.indices.size() / corners_of(primitives));
        values.assign(own.begin(), own.end());
    }
    Quantized array;
    array.bytes.resize(4 * values.size());
    if (primitives.value_step > 0) {
        const QuantizedValues places = quantized(values, primitives.range[0], primitives.value_step);
        array.low[0] = places.low;
        for (std::size_t i = 0; i < values.size(); ++i) put(array.bytes.data() + 4 * i, places.places[i]);
    } else {
        for (std::size_t i = 0; i < values.size(); ++i) put(array.bytes.data() + 4 * i, static_cast<float>(values[i]));
    }
    const std::array<double, 4> rest{primitives.value_step, double(array.low[0]), primitives.range[0],
                                     double(primitives.values.empty())};
    array.id = XXH3_64bits_withSeed(rest.data(), sizeof rest, XXH3_64bits(array.bytes.data(), array.bytes.size()));
    return array;
}

std::string hexadecimal(std::uint64_t id) {
    constexpr std::string_view hex = "0123456789abcdef";
    std::string text(16, '0');
    for (auto digit = text.rbegin(); digit != text.rend(); ++digit, id >>= 4U) *digit = hex[id & 15U];
    return text;
}

struct Counts { // compressed bytes per array; 0: not sent, because the receiver has the array
    std::size_t vertices = 0, indices = 0, values = 0;
};

void append_arrays(std::string& json, const Primitives& primitives, const Quantized& shape, const Quantized& values,
                   double step, const Counts& counts) {
    json += ", \"mesh\": {\"id\": \"" + hexadecimal(shape.id) + "\", \"step\": ";
    append_number(json, step);
    json += ", \"low\": ";
    append_array(json, shape.low);
    if (counts.vertices > 0)
        json += ", \"bytes\": [" + std::to_string(counts.vertices) + ", " + std::to_string(counts.indices) + "]";
    json += "}";
    if (!has_values(primitives)) return;
    json += std::string(", \"values\": {\"of\": \"") + (primitives.values.empty() ? "vertices"
                                                        : primitives.points       ? "points"
                                                        : primitives.lines        ? "lines"
                                                                                  : "triangles");
    json += "\", \"id\": \"" + hexadecimal(values.id) + "\"";
    if (primitives.value_step > 0) {
        json += ", \"step\": ";
        append_number(json, primitives.value_step);
        json += ", \"origin\": ";
        append_number(json, primitives.range[0]);
        json += ", \"low\": " + std::to_string(values.low[0]);
    }
    if (counts.values > 0) json += ", \"bytes\": " + std::to_string(counts.values);
    json += "}";
}

struct Place { // index of a batch in the frame, number of batches in the frame, HeldArrays::base
    std::size_t number = 0, batches = 0;
    std::uint32_t base = 0;
};

std::string description(const Batch& batch, ciel::Vec3d origin, const std::string& arrays, const Place& place) {
    const Primitives& primitives = *batch.primitives;
    std::string json = "{\"layer\": ";
    append_string(json, primitives.layer);
    json += std::string(", \"kind\": \"") +
            (primitives.points  ? "points"
             : primitives.lines ? "lines"
                                : "triangles") +
            "\"";
    json += ", \"vertices\": " + std::to_string(batch.vertices.size());
    json += ", \"indices\": " + std::to_string(batch.indices.size());
    json += std::string(", \"normals\": ") + name_of(!primitives.normals.empty());
    json += arrays + ", \"map\": ";
    append_string(json, primitives.map);
    json += ", \"range\": ";
    append_array(json, primitives.range);
    json += ", \"scale\": " + primitives.scale + ", \"color\": ";
    append_array(json, primitives.color);
    json += std::string(", \"lit\": ") + name_of(primitives.lit);
    if (primitives.lines || primitives.points) {
        json += ", \"width\": ";
        append_number(json, primitives.line_width);
    }
    if (!primitives.clip.empty()) {
        json += ", \"clip\": ";
        append_list(json, primitives.clip, [&](const auto& plane) { append_array(json, plane); });
    }
    json += ", \"origin\": ";
    append_array(json, origin);
    json += ", \"batch\": " + std::to_string(place.number) + ", \"batches\": " + std::to_string(place.batches);
    return json + ", \"base\": " + std::to_string(place.base) + "}";
}

std::vector<std::uint8_t> with_description(const std::string& json, const std::vector<std::uint8_t>& arrays) {
    std::vector<std::uint8_t> out(4);
    out.reserve(4 + json.size() + arrays.size());
    put(out.data(), static_cast<std::uint32_t>(json.size()));
    out.insert(out.end(), json.begin(), json.end());
    out.insert(out.end(), arrays.begin(), arrays.end());
    return out;
}

std::vector<std::uint8_t> encode(const Batch& batch, ciel::Vec3d origin, double step, const HeldArrays& held,
                                 const Place& place, ArrayIds& ids) {
    const Primitives& primitives = *batch.primitives;
    const Quantized shape = shape_array(batch, step);
    const Quantized values = values_array(batch);
    Counts counts;
    std::vector<std::uint8_t> arrays;
    if (!held.ids.contains(shape.id)) {
        counts.vertices = append_vertices(arrays, shape.bytes, shape.stride);
        counts.indices = primitives.lines || primitives.points
                             ? append_sequence(arrays, batch.indices, batch.vertices.size())
                             : append_triangles(arrays, batch.indices, batch.vertices.size());
    }
    ids.insert(shape.id);
    if (has_values(primitives)) {
        if (!held.ids.contains(values.id)) counts.values = append_vertices(arrays, values.bytes, values.stride);
        ids.insert(values.id);
    }
    std::string read;
    append_arrays(read, primitives, shape, values, step, counts);
    return with_description(description(batch, origin, read, place), arrays);
}

} // namespace

EncodedGeometry encode_geometry(std::span<const Primitives> all, ciel::Vec3d origin, double step,
                                const HeldArrays& held, std::size_t max_vertices) {
    std::vector<Batch> batches;
    for (const Primitives& primitives : all) {
        check(primitives);
        split(primitives, max_vertices, batches);
    }
    EncodedGeometry out;
    out.payloads.reserve(batches.size());
    for (const Batch& batch : batches)
        out.payloads.push_back(
            encode(batch, origin, step, held, {out.payloads.size(), batches.size(), held.base}, out.ids));
    if (batches.empty()) {
        const Primitives nothing;
        out.payloads.push_back(with_description(description({&nothing, 0, {}, {}}, origin, "", {0, 0, held.base}), {}));
    }
    return out;
}

} // namespace server::wire
