#include "methods/base64.hpp"
#include "methods/scene_source.hpp"
#include "wire/joined_surface.hpp"

#include <algorithm>
#include <sstream>

namespace ciel::methods {
namespace {

// The layer's iso-values as one surface, one after the other.
wire::JoinedSurface joined(const session::Geometry& geometry, const std::string& layer) {
    wire::JoinedSurface result;
    for (const session::Drawable& drawable : geometry.drawables) {
        if (drawable.layer != layer) continue;
        std::vector<wire::NamedValues> values;
        if (drawable.scalars) values.push_back({drawable.array, *drawable.scalars});
        result.add(drawable.shape->surface, values);
    }
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
    const wire::JoinedSurface surface = joined(*geometry, params.layer);
    const wire::SurfaceFormat format = wire::surface_format("." + params.format);
    std::ostringstream out;
    const wire::ExportedCounts written =
        wire::write_surface(format, {surface.surface(), geometry->origin, surface.values(), params.triangles}, out);
    const std::string bytes = std::move(out).str();
    if (bytes.size() > context.server.limits().export_bytes)
        throw session::LimitReached("the surface has " + std::to_string(bytes.size() >> 20) +
                                    " MB, more than an export may have; use `ciel extract`");
    return {mime_of(format), params.layer + "." + params.format,
            base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}),
            static_cast<std::int64_t>(written.polygons), static_cast<std::int64_t>(written.vertices)};
}

} // namespace ciel::methods
