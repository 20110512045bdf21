// Lighting options of `ciel render`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace CLI {
class App;
}

namespace server::app {

struct LightingOptions {
    bool unlit = false, ambient_occlusion = false;
    std::optional<double> ambient, headlight, key_light, occlusion_radius, occlusion_strength;

    void add_to(CLI::App& command);
    // Throws UsageError on occlusion options without --ambient-occlusion.
    [[nodiscard]] nlohmann::json patch() const;
};

} // namespace server::app
