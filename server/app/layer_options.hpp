// Options of `ciel render` in addition to SceneOptions: layers of the mesh's boundary, and the style of all layers.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace server::app {

struct LayerOptions {
    bool surface = false, edges = false, flat = false;
    std::string contours; // on slices: "ARRAY" or "ARRAY=VALUE,..."
    std::string contour_map;
    std::vector<std::string> clips;
    std::optional<std::string> points, threshold;
    std::optional<double> feature_edges; // degrees
    std::optional<double> opacity;
    std::optional<int> volume_slices;
    std::optional<std::string> volume_direction;
    std::optional<double> volume_unit_length;
    bool volume_unshaded = false;
    std::vector<std::string> patches;

    void add_to(CLI::App& command);
    [[nodiscard]] bool has_layers() const { return surface || points || feature_edges; }
    [[nodiscard]] bool any() const {
        return has_layers() || edges || flat || opacity || volume_slices || volume_direction || volume_unit_length ||
               volume_unshaded || !patches.empty() || !contours.empty() || !contour_map.empty() || !clips.empty() ||
               threshold;
    }
    // Throws UsageError on a malformed option, and on an option that applies to no layer.
    void apply(nlohmann::json& layers) const;

private:
    void shape_volumes(nlohmann::json& layers) const;
};

} // namespace server::app
