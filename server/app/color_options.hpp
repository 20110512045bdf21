// Color options of `ciel render`. They set the coloring of layers in the scene document.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace server::app {

struct ColorOptions {
    std::optional<std::string> array, map, points, range, nan, below, above;
    std::optional<int> steps;
    bool reverse = false, log = false, symmetric = false;

    void add_to(CLI::App& command);
    [[nodiscard]] bool any() const;
    // Replaces the members of a layer's coloring for which options are given. Throws UsageError on a malformed option.
    void apply_to(nlohmann::json& color) const;
};

// Throws UsageError if `name` is not a color map. The error lists the color maps.
void check_map(const std::string& option, const std::string& name);

} // namespace server::app
