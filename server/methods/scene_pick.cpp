#include "frames/picture.hpp"
#include "methods/scene_source.hpp"
#include "probe/shown_bounds.hpp"
#include "probe/sight.hpp"

namespace server::methods {

protocol::ScenePickResult scene_pick(CallContext& context, const protocol::ScenePickParams& params) {
    frames::check_picture_size(context.server.limits(), params.width, params.height);
    const geometry::ViewSize size{static_cast<std::uint32_t>(params.width), static_cast<std::uint32_t>(params.height)};
    SceneSource source(context, params.session, params.scene);
    Progress progress(context, params.progress, params.session);
    const scene::CheckedScene& checked = source.version().checked;
    const auto geometry = source.geometry(progress);
    geometry::require_read(*geometry);
    progress.begin("measuring");
    const auto crossings = probe::crossings(*geometry, checked, size, params.pixel);
    protocol::ScenePickResult picked;
    if (const auto seen = probe::bounds_in_view(*geometry, checked, size)) {
        ciel::Vec3d& center = picked.center.emplace();
        for (std::size_t k = 0; k < 3; ++k) center[k] = (seen->low[k] + seen->high[k]) / 2;
    }
    if (crossings.empty()) return picked;
    const probe::Crossing& first = crossings.front();
    picked.position = first.position;
    picked.layer = geometry->drawables[first.drawable].layer;
    picked.patch = probe::patch_of(first, *geometry, checked);
    return picked;
}

} // namespace server::methods
