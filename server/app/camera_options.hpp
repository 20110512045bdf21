// Camera options of `ciel render`.
#pragma once

#include "engine/view.hpp"
#include "geometry/scene_geometry.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace server::app {

struct CameraOptions {
    std::optional<std::string> camera;
    std::optional<double> field_of_view;
    bool parallel = false;

    void add_to(CLI::App& command);
    // Throws UsageError on a malformed or out-of-range option.
    void apply(nlohmann::json& document) const;
    // Applies --field-of-view and --parallel to the scene's camera, if there is one, and does not move the camera.
    void project(std::optional<scene::Camera>& given) const;
    // Returns the scene. If the scene has no camera, the result has a camera that shows all of `box`.
    [[nodiscard]] scene::CheckedScene stand_back(const scene::CheckedScene& checked, const geometry::Geometry& geometry,
                                                 geometry::ViewSize size, const geometry::BoundingBox& box) const;
};

} // namespace server::app
