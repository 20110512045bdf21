#include "geometry/viewpoint.hpp"

#include "annotations/make_room.hpp"
#include "fonts/font.hpp"
#include "geometry/scene_annotations.hpp"

namespace ciel::geometry {

annotations::Camera camera_of(const Geometry& geometry, const scene::Scene& scene, double aspect) {
    if (!scene.camera) return annotations::default_camera(geometry.bounds_min, geometry.bounds_max, aspect);
    const scene::Camera& camera = *scene.camera;
    return {camera.position, camera.target, camera.up, camera.fov, camera.parallel, camera.parallel_height.value_or(1)};
}

// Views use the same camera as annotated pictures of the scene, so that a point has the same pixel in both.
annotations::Camera default_view(const Geometry& geometry, const scene::Scene& scene, int width, int height,
                                 double fov_degrees, bool parallel, const std::optional<BoundingBox>& of) {
    annotations::AnnotatedPicture picture;
    picture.width = width;
    picture.height = height;
    picture.bounds_min = of ? of->low : geometry.bounds_min;
    picture.bounds_max = of ? of->high : geometry.bounds_max;
    const double aspect = static_cast<double>(width) / height;
    picture.camera = annotations::default_camera(picture.bounds_min, picture.bounds_max, aspect, fov_degrees);
    picture.camera.parallel = parallel;
    picture.annotations = annotations_of(geometry, scene, LegendsOf::all_layers);
    fonts::Font font;
    return annotations::clear_of_annotations(picture, font);
}

annotations::Viewpoint viewpoint_of(const Geometry& geometry, const scene::Scene& scene, int width, int height) {
    annotations::Viewpoint viewpoint;
    viewpoint.width = width;
    viewpoint.height = height;
    viewpoint.origin = geometry.origin;
    viewpoint.camera = scene.camera ? camera_of(geometry, scene, static_cast<double>(width) / height)
                                    : default_view(geometry, scene, width, height);
    viewpoint.bounds_min = geometry.bounds_min;
    viewpoint.bounds_max = geometry.bounds_max;
    return viewpoint;
}

} // namespace ciel::geometry
