// Color options of `ciel render`, written to a coloring of the scene document.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace ciel::app {

struct ColorOptions {
    std::optional<std::string> array, map, points, range, nan, below, above;
    std::optional<int> steps;
    bool reverse = false, log = false, symmetric = false;

    void add_to(CLI::App& command);
    [[nodiscard]] bool any() const;
    // Overrides members of a layer's coloring by the given options. Throws UsageError on a malformed option.
    void apply_to(nlohmann::json& color) const;
};

// Throws UsageError with the list of color maps if `name` is not one of them.
void check_map(const std::string& option, const std::string& name);

} // namespace ciel::app
