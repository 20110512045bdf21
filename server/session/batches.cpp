#include "session/batches.hpp"

#include "session/frame_workers.hpp"

#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

namespace ciel::session {
namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "floats and indices are sent as they lie in memory");

constexpr std::size_t primitives_per_batch = 30'000; // about 1 MB: a message is decoded in one go in the browser

// A run of a drawable's triangles or lines with the vertices it uses, numbered from 0.
struct Batch {
    std::vector<Index> vertices, indices;
};

std::vector<Batch> split(const Drawable& drawable) {
    const Shape& shape = *drawable.shape;
    const std::size_t step = primitives_per_batch * (shape.lines ? 2 : 3);
    std::vector<Index> local(shape.surface.positions.size()), seen_in(shape.surface.positions.size(), none);
    std::vector<Batch> batches;
    for (std::size_t begin = 0; begin < shape.indices.size(); begin += step) {
        const auto number = static_cast<Index>(batches.size());
        Batch& batch = batches.emplace_back();
        for (std::size_t i = begin; i < std::min(begin + step, shape.indices.size()); ++i) {
            const Index vertex = shape.indices[i];
            if (seen_in[vertex] != number) {
                seen_in[vertex] = number;
                local[vertex] = static_cast<Index>(batch.vertices.size());
                batch.vertices.push_back(vertex);
            }
            batch.indices.push_back(local[vertex]);
        }
    }
    return batches;
}

template <class T>
void append(std::vector<std::uint8_t>& out, const T* values, std::size_t count) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(values);
    out.insert(out.end(), bytes, bytes + count * sizeof(T));
}

template <class T>
void append_used(std::vector<std::uint8_t>& out, const std::vector<T>& values, const std::vector<Index>& used) {
    const std::size_t at = out.size();
    out.resize(at + used.size() * sizeof(T));
    for (std::size_t i = 0; i < used.size(); ++i) std::memcpy(&out[at + i * sizeof(T)], &values[used[i]], sizeof(T));
}

void append_json(std::vector<std::uint8_t>& out, const json& description) {
    std::string text = description.dump(-1, ' ', false, json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto length = static_cast<std::uint32_t>(text.size());
    append(out, &length, 1);
    append(out, text.data(), text.size());
}

json description_of(const Drawable& drawable, const Batch& batch, const Vec3d& origin) {
    const Shape& shape = *drawable.shape;
    return {{"layer", drawable.layer},
            {"kind", shape.lines ? "lines" : "triangles"},
            {"vertices", batch.vertices.size()},
            {"indices", batch.indices.size()},
            {"normals", !shape.surface.normals.empty()},
            {"scalars", static_cast<bool>(drawable.scalars)},
            {"map", drawable.map},
            {"range", drawable.range},
            {"color", drawable.color},
            {"lit", drawable.lit},
            {"origin", origin}};
}

std::vector<std::uint8_t> batch_message(const Drawable& drawable, const Batch& batch, json description) {
    const Surface& surface = drawable.shape->surface;
    std::vector<std::uint8_t> message(wire::frame_header_bytes);
    append_json(message, description);
    append_used(message, surface.positions, batch.vertices);
    if (!surface.normals.empty()) append_used(message, surface.normals, batch.vertices);
    if (drawable.scalars) append_used(message, *drawable.scalars, batch.vertices);
    append(message, batch.indices.data(), batch.indices.size());
    return message;
}

} // namespace

std::vector<std::vector<std::uint8_t>> geometry_messages(wire::FrameHeader& header, const Geometry& geometry) {
    const auto started = Clock::now();
    std::vector<std::pair<const Drawable*, Batch>> batches;
    for (const Drawable& drawable : geometry.drawables)
        for (Batch& batch : split(drawable)) batches.emplace_back(&drawable, std::move(batch));

    std::vector<std::vector<std::uint8_t>> messages;
    for (std::size_t i = 0; i < batches.size(); ++i) {
        const auto& [drawable, batch] = batches[i];
        json description = description_of(*drawable, batch, geometry.origin);
        description["batch"] = i;
        description["batches"] = batches.size();
        messages.push_back(batch_message(*drawable, batch, std::move(description)));
    }
    if (messages.empty()) {
        messages.emplace_back(wire::frame_header_bytes);
        append_json(messages.back(), {{"batch", 0}, {"batches", 0}, {"vertices", 0}, {"indices", 0}});
    }
    header.encode_ms = std::chrono::duration<float, std::milli>(Clock::now() - started).count();
    const auto common = header.flags;
    for (auto& message : messages) {
        header.flags = common;
        if (&message == &messages.front()) header.flags |= wire::first_of_frame;
        if (&message == &messages.back()) header.flags |= wire::last_of_frame;
        header.payload_bytes = static_cast<std::uint32_t>(message.size() - wire::frame_header_bytes);
        wire::write_frame_header(
            header, std::span<std::uint8_t, wire::frame_header_bytes>(message.data(), wire::frame_header_bytes));
    }
    return messages;
}

ContentKey content_of(const Geometry& geometry) {
    json key = json::array({geometry.time, geometry.origin});
    for (const Drawable& drawable : geometry.drawables)
        key.push_back(
            {drawable.layer, drawable.identity, drawable.revision, drawable.map, drawable.range, drawable.color});
    return key.dump(-1, ' ', false, json::error_handler_t::replace);
}

} // namespace ciel::session
