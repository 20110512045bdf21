#include "methods/scene_source.hpp"
#include "session/picture.hpp"
#include "session/shown_bounds.hpp"
#include "session/sight.hpp"

namespace ciel::methods {

protocol::ScenePickResult scene_pick(Context& context, const protocol::ScenePickParams& params) {
    session::check_picture_size(context.server.limits(), params.width, params.height);
    const session::ViewSize size{static_cast<std::uint32_t>(params.width), static_cast<std::uint32_t>(params.height)};
    SceneSource source(context, params.session, params.scene);
    const scene::Scene& scene = source.version().scene;
    const auto geometry = source.geometry();
    const auto crossings = session::crossings(*geometry, scene, size, params.pixel);
    protocol::ScenePickResult picked;
    if (const auto seen = session::bounds_in_view(*geometry, scene, size)) {
        Vec3d& centre = picked.centre.emplace();
        for (std::size_t k = 0; k < 3; ++k) centre[k] = (seen->low[k] + seen->high[k]) / 2;
    }
    if (crossings.empty()) return picked;
    const session::Crossing& first = crossings.front();
    picked.position = first.position;
    picked.layer = geometry->drawables[first.drawable].layer;
    picked.patch = session::patch_of(first, *geometry, scene, *source.loaded().dataset());
    return picked;
}

} // namespace ciel::methods
