#include "geometry/clip.hpp"
#include "geometry/places.hpp"
#include "methods/base64.hpp"
#include "methods/scene_source.hpp"
#include "wire/files/joined_surface.hpp"
#include "wire/files/surface_files.hpp"

#include <algorithm>
#include <sstream>

namespace server::methods {
namespace {

// The part of a drawable inside the clip planes, or the whole surface if the scene has no clip planes.
struct Shown {
    ciel::ClippedSurface cut;
    bool is_cut = false;
    const ciel::Surface* whole = nullptr;
    std::vector<ciel::Vec3d> whole_places;
    std::vector<wire::NamedValues> values;

    [[nodiscard]] const ciel::Surface& surface() const { return is_cut ? cut.surface : *whole; }
    [[nodiscard]] std::span<const ciel::Vec3d> places() const { return is_cut ? cut.places : whole_places; }
};

Shown shown_of(const geometry::Geometry& geometry, const geometry::Drawable& drawable, const store::Dataset& dataset) {
    Shown shown;
    shown.whole = &drawable.shape->surface;
    shown.is_cut = !geometry.clip.empty();
    shown.whole_places = geometry::places_of(*shown.whole, geometry, dataset);
    if (shown.is_cut) shown.cut = geometry::clipped(geometry, drawable, shown.whole_places);
    if (!drawable.scalars) return shown;
    shown.values.push_back(shown.is_cut
                               ? wire::NamedValues{drawable.array, shown.cut.values, drawable.scalars->has_doubles()}
                               : wire::NamedValues::copy_of(drawable.array, *drawable.scalars));
    return shown;
}

// Throws LimitReached if the file would exceed Limits::export_bytes.
wire::JoinedSurface joined(const CallContext& context, const geometry::Geometry& geometry,
                           const store::Dataset& dataset, const std::string& layer, wire::SurfaceFormat format,
                           bool triangles) {
    const std::size_t limit = context.server.limits().export_bytes;
    std::uint64_t bytes = 0;
    wire::JoinedSurface result;
    for (const geometry::Drawable& drawable : geometry.drawables) {
        if (drawable.layer != layer || !drawable.polygons()) continue;
        context.check_wanted();
        const Shown shown = shown_of(geometry, drawable, dataset);
        wire::JoinedSurface one;
        one.add(shown.surface(), shown.values);
        bytes += wire::body_bytes(format, {one.surface(), geometry.origin, one.values(), triangles});
        if (bytes > limit)
            throw limits::LimitReached("the file would have more than the " + std::to_string(limit >> 20) +
                                       " MB that an export may have; use `ciel extract`");
        result.add(shown.surface(), shown.values, shown.places());
    }
    return result;
}

bool has_polygons(const scene::Layer& layer) {
    return std::holds_alternative<scene::IsoLayer>(layer.kind) ||
           std::holds_alternative<scene::SliceLayer>(layer.kind) ||
           std::holds_alternative<scene::SurfaceLayer>(layer.kind);
}

// Memory in sizes of the file: the stream, the file and three base64 copies (result, JSON, text), each 4/3 as large.
constexpr std::size_t copies_of_a_file = 6;

struct File {
    std::string bytes;
    wire::ExportedCounts counts;
    ciel::Vec3d origin{};
};

File file_of(CallContext& context, SceneSource& source, const protocol::SurfaceExportParams& params) {
    const wire::SurfaceFormat format = wire::surface_format("." + params.format);
    Progress progress(context, params.progress, params.session);
    const auto geometry = source.geometry(progress);
    geometry::require_complete(*geometry);
    progress.begin("writing");
    const wire::JoinedSurface surface =
        joined(context, *geometry, *source.version().checked.dataset(), params.layer, format, params.triangles);
    context.making.change(copies_of_a_file * wire::body_bytes(format, {surface.surface(), geometry->origin,
                                                                       surface.values(), params.triangles}));
    const ciel::Vec3d origin =
        params.origin || wire::has_floats(format) ? wire::file_origin(geometry->first_mesh_bounds) : ciel::Vec3d{};
    std::ostringstream out;
    const wire::ExportedCounts counts = wire::write_surface(
        format, {surface.surface(), geometry->origin, surface.values(), params.triangles, origin, surface.places()},
        out);
    return {std::move(out).str(), counts, origin};
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

protocol::SurfaceExportResult surface_export(CallContext& context, const protocol::SurfaceExportParams& params) {
    SceneSource source(context, params.session, params.scene);
    const auto& layers = source.version().scene().layers;
    const auto layer =
        std::find_if(layers.begin(), layers.end(), [&](const auto& one) { return one.id == params.layer; });
    if (layer == layers.end()) throw limits::NotFound("the scene has no layer " + params.layer);
    if (!layer->visible) throw InvalidParams("/layer", "layer " + params.layer + " is not visible; show it first");
    if (!has_polygons(*layer))
        throw InvalidParams("/layer", "layer " + params.layer +
                                          " has no polygons; iso-surfaces, slices and surfaces can be exported");

    const File file = file_of(context, source, params);
    context.check_wanted();
    return {mime_of(wire::surface_format("." + params.format)),
            params.layer + "." + params.format,
            base64({reinterpret_cast<const std::uint8_t*>(file.bytes.data()), file.bytes.size()}),
            static_cast<std::int64_t>(file.counts.polygons),
            static_cast<std::int64_t>(file.counts.vertices),
            file.origin};
}

} // namespace server::methods
