#include "methods/scene_source.hpp"
#include "session/picture.hpp"

namespace ciel::methods {

protocol::SceneCameraResult scene_camera(Context& context, const protocol::SceneCameraParams& params) {
    session::check_picture_size(context.server.limits(), params.width, params.height);
    SceneSource source(context, params.session, params.scene);
    const render::Camera camera = session::frame_of(*source.geometry(), source.version().scene,
                                                    static_cast<int>(params.width), static_cast<int>(params.height), 1)
                                      .camera;
    protocol::SceneCameraResult seen{camera.position, camera.target};
    seen.up = camera.up;
    seen.fov = camera.fov_degrees;
    seen.parallel = camera.parallel;
    if (camera.parallel) seen.parallel_height = camera.parallel_height;
    return seen;
}

} // namespace ciel::methods
