#include "methods/scene_source.hpp"
#include "probe/shown_bounds.hpp"

namespace server::methods {

protocol::SceneBoundsResult scene_bounds(CallContext& context, const protocol::SceneBoundsParams& params) {
    SceneSource source(context, params.session, params.scene);
    Progress progress(context, params.progress, params.session);
    const auto geometry = source.geometry(progress);
    geometry::require_read(*geometry);
    progress.begin("measuring");
    const scene::CheckedScene& checked = source.version().checked;
    const bool is_drawn = params.of == "drawn";
    const auto [low, high] =
        is_drawn ? probe::drawn_bounds(*geometry, checked) : probe::shown_bounds(*geometry, checked);
    return {{low[0], high[0], low[1], high[1], low[2], high[2]}};
}

} // namespace server::methods
