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
    // If the scene has a camera, applies --field-of-view and --parallel to it, and does not move it.
    void project(std::optional<scene::Camera>& given) const;
    // Returns the scene. If it has no camera, the result has a camera that shows all of `box`.
    [[nodiscard]] scene::CheckedScene stand_back(const scene::CheckedScene& checked, const geometry::Geometry& geometry,
                                                 geometry::ViewSize size, const geometry::BoundingBox& box) const;
};

} // namespace server::app
