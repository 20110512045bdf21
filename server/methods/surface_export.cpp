#include "methods/base64.hpp"
#include "methods/scene_source.hpp"
#include "wire/surface_files.hpp"

#include <algorithm>
#include <sstream>

namespace ciel::methods {
namespace {

// The layer's iso-values as one surface, one after the other.
struct Joined {
    Surface surface;
    std::vector<wire::NamedValues> values;

    void add(const session::Drawable& drawable) {
        const Surface& from = drawable.shape->surface;
        const auto first_vertex = static_cast<Index>(surface.positions.size());
        const auto first_corner = static_cast<Index>(surface.polygon_vertex.size());
        const auto append = [](auto& to, const auto& more) { to.insert(to.end(), more.begin(), more.end()); };
        append(surface.positions, from.positions);
        append(surface.normals, from.normals);
        append(surface.points, from.points);
        append(surface.polygon_cell, from.polygon_cell);
        for (const Index vertex : from.polygon_vertex) surface.polygon_vertex.push_back(first_vertex + vertex);
        for (std::size_t i = 1; i < from.polygon_offset.size(); ++i)
            surface.polygon_offset.push_back(first_corner + from.polygon_offset[i]);
        if (!drawable.scalars) return;
        if (values.empty()) values.push_back({drawable.array, {}});
        append(values.front().values, *drawable.scalars);
    }
};

Joined joined(const session::Geometry& geometry, const std::string& layer) {
    Joined result;
    for (const session::Drawable& drawable : geometry.drawables)
        if (drawable.layer == layer) result.add(drawable);
    return result;
}

const char* mime_of(wire::SurfaceFormat format) {
    switch (format) {
    case wire::SurfaceFormat::ply:
        return "application/ply";
    case wire::SurfaceFormat::stl:
        return "model/stl";
    case wire::SurfaceFormat::vtp:
        return "application/xml";
    }
    return "application/octet-stream";
}

} // namespace

protocol::SurfaceExportResult surface_export(Context& context, const protocol::SurfaceExportParams& params) {
    const SceneSource source(context, params.session, params.scene);
    const auto& layers = source.version().scene.layers;
    const auto layer =
        std::find_if(layers.begin(), layers.end(), [&](const auto& one) { return one.id == params.layer; });
    if (layer == layers.end()) throw session::NotFound("the scene has no layer " + params.layer);
    if (!layer->visible) throw InvalidParams("/layer", "layer " + params.layer + " is not visible; show it first");
    if (std::holds_alternative<scene::OutlineLayer>(layer->kind))
        throw InvalidParams("/layer", "layer " + params.layer + " is an outline and has no polygons");

    const auto geometry = source.geometry();
    const Joined surface = joined(*geometry, params.layer);
    const wire::SurfaceFormat format = wire::surface_format("." + params.format);
    std::ostringstream out;
    wire::write_surface(format, {surface.surface, geometry->origin, surface.values, params.triangles}, out);
    const std::string bytes = std::move(out).str();
    if (bytes.size() > context.server.limits().export_bytes)
        throw session::LimitReached("the surface has " + std::to_string(bytes.size() >> 20) +
                                    " MB, more than an export may have; use `ciel extract`");
    const auto written =
        wire::exported_polygons(surface.surface, params.triangles || format == wire::SurfaceFormat::stl);
    return {mime_of(format), params.layer + "." + params.format,
            base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}),
            static_cast<std::int64_t>(written.offset.size() - 1), static_cast<std::int64_t>(written.vertices.size())};
}

} // namespace ciel::methods
