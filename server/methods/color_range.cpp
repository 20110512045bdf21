#include "methods/scene_source.hpp"
#include "probe/visible_range.hpp"

namespace server::methods {

protocol::ColorRangeResult color_range(CallContext& context, const protocol::ColorRangeParams& params) {
    SceneSource source(context, params.session, params.scene);
    Progress progress(context, params.progress, params.session);
    const scene::CheckedScene& checked = source.version().checked;
    const auto& layers = checked.scene().layers;
    for (const std::string& id : params.layers)
        if (std::none_of(layers.begin(), layers.end(), [&](const auto& layer) { return layer.id == id; }))
            throw limits::NotFound("the scene has no layer " + id);
    const auto geometry = source.geometry(progress);
    geometry::require_read(*geometry);
    progress.begin("measuring");
    return {probe::visible_range(*geometry, checked, params.layers, params.aspect, params.of == "contours")};
}

} // namespace server::methods
