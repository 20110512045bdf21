#include "frames/picture.hpp"
#include "frames/position_under.hpp"
#include "methods/cell_extremes.hpp"
#include "methods/scene_source.hpp"
#include "probe/probe.hpp"
#include "probe/sight.hpp"

#include <cmath>

namespace server::methods {
namespace {

geometry::ViewSize size_of(const CallContext& context, const protocol::ProbePointParams& params) {
    if (!params.width) throw InvalidParams("/width", "a pixel needs /width, the width of its picture");
    if (!params.height) throw InvalidParams("/height", "a pixel needs /height, the height of its picture");
    frames::check_picture_size(context.server.limits(), *params.width, *params.height);
    return {static_cast<std::uint32_t>(*params.width), static_cast<std::uint32_t>(*params.height)};
}

void name_what_is_there(protocol::ProbePointResult& result, const geometry::Geometry& geometry,
                        const scene::CheckedScene& checked, geometry::ViewSize size,
                        const protocol::ProbePointParams& params) {
    const auto there =
        probe::crossing_at(probe::crossings(geometry, checked, size, *params.pixel), geometry, *result.position);
    if (!there) return;
    result.layer = geometry.drawables[there->drawable].layer;
    result.patch = probe::patch_of(*there, geometry, checked);
}

std::optional<std::map<std::string, protocol::CellExtremes>> extremes_at(const store::Dataset& dataset,
                                                                         std::size_t step) {
    std::map<std::string, protocol::CellExtremes> found;
    for (const store::ArrayInfo& array : dataset.info().arrays)
        if (array.association == store::Association::cell)
            if (auto extremes = answer_of(store::range_extremes(dataset, array, step)))
                found.emplace(array.name, *extremes);
    return found.empty() ? std::nullopt : std::optional(std::move(found));
}

std::optional<std::int64_t> id_of(ciel::Index id) {
    return id == ciel::none ? std::nullopt : std::optional<std::int64_t>(id);
}

} // namespace

protocol::ProbePointResult probe_point(CallContext& context, const protocol::ProbePointParams& params) {
    if (params.position.has_value() == params.pixel.has_value())
        throw InvalidParams("/position", "give either a position or a pixel");
    const auto size = params.pixel ? size_of(context, params) : geometry::ViewSize{};
    SceneSource source(context, params.session, params.scene);
    Progress progress(context, params.progress, params.session);
    const auto dataset = source.version().checked.dataset();
    if (dataset->steps().empty()) throw ciel::Error(dataset->info().name + " has no time step yet; append a step");
    const std::size_t step = dataset->step_at(source.version().scene().time);
    try {
        source.version().checked.loaded()->require_read(step);
    } catch (const store::NotYetRead& late) { // arrays that cannot be read from the source get no values
        if (!late.has_failed) throw;
    }
    // Makes the geometry on this thread, so that the picture worker is free for other calls meanwhile.
    const auto geometry = params.pixel ? source.geometry(progress) : nullptr;
    progress.begin("measuring");
    context.server.services().require_room(); // the locator needs the topology
    const auto locator = source.version().checked.loaded()->locator(step);

    std::optional<ciel::Vec3d> position = params.position;
    if (params.pixel) {
        progress.begin("waiting");
        position = context.server.picture_workers().run([&](engine::Worker& worker) {
            context.check_wanted();
            progress.begin("measuring");
            return dataset->naming_changed_file([&] {
                return frames::position_under(*geometry, source.version().checked, size, *params.pixel, *locator,
                                              worker.renderer(), [&] { context.check_wanted(); });
            });
        });
    }
    if (!position) return {};
    const probe::Probed probed = probe::probe(*dataset, step, *locator, *position);
    protocol::ProbePointResult result;
    result.hit = probed.cell != ciel::none;
    result.position = position;
    result.vertex = id_of(probed.vertex);
    result.cell = id_of(probed.cell);
    result.values = probed.values;
    result.solver_cell = probed.solver_cell;
    result.solver_vertex = probed.solver_vertex;
    if (result.hit) result.extremes = extremes_at(*dataset, step);
    if (geometry) name_what_is_there(result, *geometry, source.version().checked, size, params);
    return result;
}

} // namespace server::methods
