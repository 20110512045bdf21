#include "frames/picture.hpp"
#include "geometry/viewpoint.hpp"
#include "methods/scene_source.hpp"

namespace server::methods {

protocol::SceneCameraResult scene_camera(CallContext& context, const protocol::SceneCameraParams& params) {
    frames::check_picture_size(context.server.limits(), params.width, params.height);
    SceneSource source(context, params.session, params.scene);
    Progress progress(context, params.progress, params.session);
    const annotations::ViewCamera camera =
        geometry::viewpoint_of(*source.geometry(progress), source.version().checked, static_cast<int>(params.width),
                               static_cast<int>(params.height))
            .camera;
    protocol::SceneCameraResult seen{camera.position, camera.target};
    seen.up = camera.up;
    seen.fov = camera.fov_degrees;
    seen.parallel = camera.parallel;
    if (camera.parallel) seen.parallel_height = camera.parallel_height;
    return seen;
}

} // namespace server::methods
