#include "methods/scene_source.hpp"
#include "probe/visible_range.hpp"

namespace ciel::methods {

protocol::ColorRangeResult color_range(CallContext& context, const protocol::ColorRangeParams& params) {
    SceneSource source(context, params.session, params.scene);
    const scene::Scene& scene = source.version().scene();
    for (const std::string& id : params.layers)
        if (std::none_of(scene.layers.begin(), scene.layers.end(), [&](const auto& layer) { return layer.id == id; }))
            throw limits::NotFound("the scene has no layer " + id);
    return {probe::visible_range(*source.geometry(), scene, params.layers, params.aspect, params.of == "contours")};
}

} // namespace ciel::methods
