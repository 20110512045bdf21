#include "app/camera_options.hpp"

#include "app/commands.hpp"
#include "app/scene_options.hpp"
#include "geometry/viewpoint.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace server::app {
namespace {

nlohmann::json camera_of(const std::string& text) {
    const std::vector<double> n = parse_numbers("--camera", text);
    if (n.size() != 6 && n.size() != 9)
        throw UsageError("--camera " + text + " is not of the form px,py,pz,tx,ty,tz or px,py,pz,tx,ty,tz,ux,uy,uz");
    nlohmann::json camera{{"position", {n[0], n[1], n[2]}}, {"target", {n[3], n[4], n[5]}}};
    if (n.size() == 9) camera["up"] = {n[6], n[7], n[8]};
    return camera;
}

double height_of(const scene::Camera& camera) {
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) square += std::pow(camera.target[k] - camera.position[k], 2);
    return 2 * std::sqrt(square) * std::tan(camera.fov * std::numbers::pi / 360);
}

} // namespace

void CameraOptions::add_to(CLI::App& command) {
    command
        .add_option("--camera", camera,
                    "Position, target and up direction of the camera. The default up direction is z. The default "
                    "camera shows everything that clips and thresholds keep.")
        ->type_name("px,py,pz,tx,ty,tz[,ux,uy,uz]");
    command
        .add_option("--field-of-view", field_of_view,
                    "Vertical field of view, 30 by default. A larger angle gives a stronger perspective.")
        ->type_name("DEGREES");
    command.add_flag("--parallel", parallel,
                     "Parallel projection. Its height is that of the perspective view at the camera's target.");
}

void CameraOptions::apply(nlohmann::json& document) const {
    if (field_of_view && !(*field_of_view > 0 && *field_of_view < 180))
        throw UsageError("--field-of-view must be more than 0 and less than 180 degrees");
    if (camera && document.is_object()) document["camera"] = camera_of(*camera);
}

void CameraOptions::project(std::optional<scene::Camera>& given) const {
    if (!given) return;
    if (field_of_view) given->fov = *field_of_view;
    if (!parallel || given->parallel) return;
    given->parallel = true;
    given->parallel_height = height_of(*given);
}

scene::CheckedScene CameraOptions::stand_back(const scene::CheckedScene& checked, const geometry::Geometry& geometry,
                                              geometry::ViewSize size, const geometry::BoundingBox& box) const {
    if (checked.scene().camera) return checked;
    const annotations::ViewCamera seen =
        geometry::default_view(geometry, checked, static_cast<int>(size.width), static_cast<int>(size.height),
                               field_of_view.value_or(annotations::ViewCamera{}.fov_degrees), parallel, box);
    return checked.with_camera(
        {seen.position, seen.target, seen.up, seen.fov_degrees, seen.parallel, seen.parallel_height});
}

} // namespace server::app
