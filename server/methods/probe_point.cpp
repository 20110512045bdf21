#include "methods/cell_extremes.hpp"
#include "methods/scene_source.hpp"
#include "session/picture.hpp"
#include "session/probe.hpp"
#include "session/sight.hpp"

#include <cmath>

namespace ciel::methods {
namespace {

session::ViewSize size_of(const Context& context, const protocol::ProbePointParams& params) {
    if (!params.width) throw InvalidParams("/width", "a pixel needs the width of the picture it is in");
    if (!params.height) throw InvalidParams("/height", "a pixel needs the height of the picture it is in");
    session::check_picture_size(context.server.limits(), *params.width, *params.height);
    return {static_cast<std::uint32_t>(*params.width), static_cast<std::uint32_t>(*params.height)};
}

// What of the scene is under the pixel at that position.
void name_what_is_there(protocol::ProbePointResult& result, const session::Geometry& geometry,
                        const scene::Scene& scene, session::ViewSize size, const protocol::ProbePointParams& params,
                        const store::Dataset& dataset) {
    const auto there =
        session::crossing_at(session::crossings(geometry, scene, size, *params.pixel), geometry, *result.position);
    if (!there) return;
    result.layer = geometry.drawables[there->drawable].layer;
    result.patch = session::patch_of(*there, geometry, scene, dataset);
}

std::optional<std::map<std::string, protocol::CellExtremes>> extremes_at(const store::Dataset& dataset,
                                                                         std::size_t step) {
    std::map<std::string, protocol::CellExtremes> found;
    for (const store::ArrayInfo& array : dataset.info().arrays)
        if (array.association == store::Association::cell)
            if (auto extremes = answer_of(session::range_extremes(dataset, array, step)))
                found.emplace(array.name, *extremes);
    return found.empty() ? std::nullopt : std::optional(std::move(found));
}

std::optional<std::int64_t> id_of(Index id) { return id == none ? std::nullopt : std::optional<std::int64_t>(id); }

} // namespace

protocol::ProbePointResult probe_point(Context& context, const protocol::ProbePointParams& params) {
    if (params.position.has_value() == params.pixel.has_value())
        throw InvalidParams("/position", "give either a position or a pixel");
    const auto size = params.pixel ? size_of(context, params) : session::ViewSize{};
    SceneSource source(context, params.session, params.scene);
    const auto dataset = source.loaded().dataset();
    if (dataset->steps().empty()) throw Error(dataset->info().name + " has no time step yet");
    const std::size_t step = dataset->step_at(source.version().scene.time);
    const auto locator = context.server.locators().get(dataset, step);

    std::optional<Vec3d> position = params.position;
    std::shared_ptr<const session::Geometry> geometry;
    if (params.pixel) {
        geometry = source.geometry(); // not on the worker, which draws others meanwhile
        position = context.server.picture_workers().run([&](session::Worker& worker) {
            context.check_wanted();
            return session::position_under(*geometry, source.version().scene, size, *params.pixel, *locator, worker,
                                           [&] { context.check_wanted(); });
        });
    }
    if (!position) return {};
    const session::Probed probed = session::probe(*dataset, step, *locator, *position);
    protocol::ProbePointResult result;
    result.hit = probed.cell != none;
    result.position = position;
    result.vertex = id_of(probed.vertex);
    result.cell = id_of(probed.cell);
    result.values = probed.values;
    result.solver_cell = probed.solver_cell;
    result.solver_vertex = probed.solver_vertex;
    if (result.hit) result.extremes = extremes_at(*dataset, step);
    if (geometry) name_what_is_there(result, *geometry, source.version().scene, size, params, *dataset);
    return result;
}

} // namespace ciel::methods
