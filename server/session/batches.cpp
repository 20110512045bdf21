#include "session/batches.hpp"

#include "session/clip.hpp"
#include "session/color_scale_of.hpp"
#include "session/frame_workers.hpp"
#include "wire/geometry_batch.hpp"

#include <nlohmann/json.hpp>

namespace ciel::session {

std::vector<std::vector<std::uint8_t>> geometry_messages(wire::FrameHeader& header, const Geometry& geometry,
                                                         double pixel_ratio) {
    const auto started = Clock::now();
    const auto planes = shader_planes(geometry);
    std::vector<wire::GeometryMesh> meshes;
    for (const Drawable& drawable : geometry.drawables) {
        const Surface& surface = drawable.shape->surface;
        wire::GeometryMesh mesh;
        mesh.layer = drawable.layer;
        mesh.positions = surface.positions;
        if (drawable.polygons()) mesh.normals = surface.normals;
        if (drawable.scalars) mesh.scalars = *drawable.scalars;
        mesh.indices = drawable.indices();
        mesh.lines = drawable.lines();
        mesh.points = drawable.points();
        mesh.line_width = drawable.line_width * static_cast<float>(pixel_ratio);
        mesh.map = drawable.scale.map;
        mesh.range = {static_cast<float>(drawable.scale.range[0]), static_cast<float>(drawable.scale.range[1])};
        mesh.color = drawable.color;
        mesh.lit = drawable.lit;
        mesh.scale = json_of(drawable.scale).dump();
        mesh.clip = planes;
        meshes.push_back(std::move(mesh));
    }
    auto messages = wire::encode_geometry(meshes, geometry.origin);
    header.encode_ms = std::chrono::duration<float, std::milli>(Clock::now() - started).count();
    const auto common = header.flags;
    for (auto& message : messages) {
        header.flags = common;
        if (&message == &messages.front()) header.flags |= wire::first_of_frame;
        if (&message == &messages.back()) header.flags |= wire::last_of_frame;
        header.payload_bytes = header.whole_bytes = static_cast<std::uint32_t>(message.size());
        std::array<std::uint8_t, wire::frame_header_bytes> bytes{};
        wire::write_frame_header(header, bytes);
        message.insert(message.begin(), bytes.begin(), bytes.end());
    }
    return messages;
}

ContentKey content_of(const Geometry& geometry) {
    nlohmann::json key = nlohmann::json::array({geometry.time, geometry.origin, shader_planes(geometry)});
    for (const Drawable& drawable : geometry.drawables)
        key.push_back({drawable.layer, drawable.identity, drawable.revision, drawable.scale.map, drawable.scale.range,
                       json_of(drawable.scale), drawable.color, drawable.line_width});
    return key.dump();
}

} // namespace ciel::session
