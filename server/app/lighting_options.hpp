// How `ciel render` is asked to light a scene, as options.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace CLI {
class App;
}

namespace ciel::app {

struct LightingOptions {
    bool unlit = false, ambient_occlusion = false;
    std::optional<double> ambient, headlight, key_light, occlusion_radius, occlusion_strength;

    void add_to(CLI::App& command);
    // As a merge patch of the scene document; empty where nothing was asked for. Throws UsageError on options of an
    // ambient occlusion that was not asked for.
    [[nodiscard]] nlohmann::json patch() const;
};

} // namespace ciel::app
