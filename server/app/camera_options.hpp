// How `ciel render` is asked to look, as options.
#pragma once

#include "engine/view.hpp"
#include "geometry/scene_geometry.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace ciel::app {

struct CameraOptions {
    std::optional<std::string> camera;
    std::optional<double> field_of_view;
    bool parallel = false;

    void add_to(CLI::App& command);
    // What was asked for instead of the document's camera. Throws UsageError.
    void apply(nlohmann::json& document) const;
    // How a camera that is known looks: from where it stands.
    void project(scene::Scene& scene) const;
    // A scene without a camera gets one that shows the whole box.
    void stand_back(scene::Scene& scene, const geometry::Geometry& geometry, geometry::ViewSize size,
                    const geometry::BoundingBox& box) const;
};

} // namespace ciel::app
