#include "methods/scene_source.hpp"
#include "session/shown_bounds.hpp"

namespace ciel::methods {

protocol::SceneBoundsResult scene_bounds(Context& context, const protocol::SceneBoundsParams& params) {
    const SceneSource source(context, params.session, params.scene);
    const auto [low, high] = session::shown_bounds(*source.geometry(), source.version().scene);
    return {{low[0], high[0], low[1], high[1], low[2], high[2]}};
}

} // namespace ciel::methods
