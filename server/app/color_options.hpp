// How `ciel render` is asked to color layers, as options; the result is a coloring of the scene document.
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
    // Puts what was asked for into the coloring of a layer, over what is there. Throws UsageError on an option that
    // cannot be read.
    void apply_to(nlohmann::json& color) const;
};

// Throws UsageError, which names those that there are, where it is none.
void check_map(const std::string& option, const std::string& name);

} // namespace ciel::app
