#include "app/layer_options.hpp"

#include "app/commands.hpp"
#include "app/scene_options.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace ciel::app {
namespace {

bool has_polygons(const nlohmann::json& layer) {
    return layer["type"] == "iso" || layer["type"] == "slice" || layer["type"] == "surface";
}

} // namespace

void LayerOptions::add_to(CLI::App& command) {
    command.add_flag("--surface", surface, "The boundary of the mesh.");
    command.add_flag("--edges", edges, "Lines along the edges of all polygons: those of the cells.");
}

void LayerOptions::apply(nlohmann::json& layers) const {
    double order = static_cast<double>(layers.size());
    if (surface) layers["surface"] = {{"type", "surface"}, {"order", order++}};
    if (edges) {
        bool any = false;
        for (auto& layer : layers) {
            if (!has_polygons(layer)) continue;
            layer["edges"] = nlohmann::json::object();
            any = true;
        }
        if (!any) throw UsageError("nothing has polygons whose edges could be drawn; give --iso, --slice or --surface");
    }
}

} // namespace ciel::app
