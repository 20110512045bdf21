#include "geometry/viewpoint.hpp"

#include "annotations/make_room.hpp"
#include "fonts/font.hpp"
#include "geometry/scene_annotations.hpp"

namespace server::geometry {

annotations::ViewCamera camera_of(const Geometry& geometry, const std::optional<scene::Camera>& given, double aspect) {
    if (!given) return annotations::default_camera(geometry.bounds_min, geometry.bounds_max, aspect);
    return {given->position, given->target, given->up, given->fov, given->parallel, given->parallel_height.value_or(1)};
}

// Views use the same camera as annotated pictures of the scene, so that a point has the same pixel in both.
annotations::ViewCamera default_view(const Geometry& geometry, const scene::CheckedScene& checked, int width,
                                     int height, double fov_degrees, bool parallel,
                                     const std::optional<BoundingBox>& of) {
    annotations::AnnotatedPicture picture;
    picture.width = width;
    picture.height = height;
    picture.bounds_min = of ? of->low : geometry.bounds_min;
    picture.bounds_max = of ? of->high : geometry.bounds_max;
    const double aspect = static_cast<double>(width) / height;
    picture.camera = annotations::default_camera(picture.bounds_min, picture.bounds_max, aspect, fov_degrees);
    picture.camera.parallel = parallel;
    picture.annotations = annotations_of(geometry, checked, LegendsOf::all_layers);
    fonts::Font font;
    return annotations::clear_of_annotations(picture, font);
}

annotations::Viewpoint viewpoint_of(const Geometry& geometry, const scene::CheckedScene& checked, int width,
                                    int height) {
    annotations::Viewpoint viewpoint;
    viewpoint.width = width;
    viewpoint.height = height;
    viewpoint.origin = geometry.origin;
    const std::optional<scene::Camera>& given = checked.scene().camera;
    viewpoint.camera = given ? camera_of(geometry, given, static_cast<double>(width) / height)
                             : default_view(geometry, checked, width, height);
    viewpoint.bounds_min = geometry.bounds_min;
    viewpoint.bounds_max = geometry.bounds_max;
    return viewpoint;
}

} // namespace server::geometry
