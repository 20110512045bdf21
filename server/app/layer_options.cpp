#include "app/layer_options.hpp"

#include "app/color_options.hpp"
#include "app/commands.hpp"
#include "app/scene_options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

namespace server::app {
namespace {

bool has_polygons(const nlohmann::json& layer) {
    return layer["type"] == "iso" || layer["type"] == "slice" || layer["type"] == "surface";
}

bool is_slice(const nlohmann::json& layer) { return layer["type"] == "slice"; }

bool is_of_cells(const nlohmann::json& layer) {
    return layer["type"] == "surface" || layer["type"] == "edges" || layer["type"] == "points";
}

bool is_iso(const nlohmann::json& layer) { return layer["type"] == "iso"; }

bool is_volume(const nlohmann::json& layer) { return layer["type"] == "volume"; }

bool has_opacity(const nlohmann::json& layer) { return layer["type"] != "outline" && layer["type"] != "clip"; }

nlohmann::json threshold_of(const std::string& text) {
    const auto equals = text.rfind('=');
    if (equals != std::string::npos && equals > 0)
        if (const auto range = parse_numbers("--threshold", text.substr(equals + 1)); range.size() == 2)
            return {{"array", text.substr(0, equals)}, {"range", range}};
    throw UsageError("--threshold " + text + " is not of the form ARRAY=MIN,MAX");
}

template <class Wanted, class Change>
int change(nlohmann::json& layers, Wanted wanted, Change make) {
    int changed = 0;
    for (auto& layer : layers)
        if (wanted(layer)) {
            make(layer);
            ++changed;
        }
    return changed;
}

// `text`: "p" or "p=1,2,3". Splits at the last '=', because an array name may contain '='.
nlohmann::json contours_of(const std::string& text) {
    const auto equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0) return {{"array", text}};
    return {{"array", text.substr(0, equals)}, {"values", parse_numbers("--contours", text.substr(equals + 1))}};
}

constexpr const char* clip_form = " is not of the form x=VALUE, y=VALUE or z=VALUE, with a - before the axis for the "
                                  "other side, or ox,oy,oz,nx,ny,nz";

nlohmann::json clip_of(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) {
        const std::vector<double> n = parse_numbers("--clip", text);
        if (n.size() != 6) throw UsageError("--clip " + text + clip_form);
        return {{"type", "clip"}, {"origin", {n[0], n[1], n[2]}}, {"normal", {n[3], n[4], n[5]}}};
    }
    const bool inverted = text.starts_with('-');
    const std::string axis = text.substr(inverted ? 1 : 0, equals - (inverted ? 1 : 0));
    const std::vector<double> value = parse_numbers("--clip", text.substr(equals + 1));
    if ((axis != "x" && axis != "y" && axis != "z") || value.size() != 1)
        throw UsageError("--clip " + text + clip_form);
    return {{"type", "clip"}, {"axis", axis}, {"value", value[0]}, {"invert", inverted}};
}

} // namespace

void LayerOptions::add_to(CLI::App& command) {
    command.add_flag("--surface", surface, "The boundary of the mesh.");
    command
        .add_option("--feature-edges", feature_edges,
                    "Edges where the boundary bends by more than DEGREES; 0 shows all edges where the boundary bends.")
        ->type_name("DEGREES");
    command.add_option("--points", points, "Vertices of the boundary, or all vertices of the mesh.")
        ->check(CLI::IsMember({"boundary", "all"}));
    command
        .add_option("--threshold", threshold,
                    "Limit --surface, --feature-edges and --points to cells in a range. A point array must be in the "
                    "range at all vertices of the cell, a cell array in the cell.")
        ->type_name("ARRAY=MIN,MAX");
    command
        .add_option("--patches", patches,
                    "Limit --surface, --feature-edges and --points boundary to the named patches.")
        ->type_name("NAME[,NAME...]")
        ->delimiter(',');
    command.add_option("--opacity", opacity, "Opacity of all layers, from 0 to 1.")->type_name("SHARE");
    command.add_flag("--flat", flat,
                     "Shade iso-surfaces with the normals of the polygons instead of the gradient of the field.");
    command
        .add_option("--volume-slices", volume_slices,
                    "Number of slices of a volume; by default 200 or more, depending on the mesh and the opacities.")
        ->type_name("N");
    command
        .add_option("--volume-direction", volume_direction,
                    "Direction in which volumes are sliced: an axis, or the view direction (screen); by default auto, "
                    "the axis nearest to the view direction.")
        ->check(CLI::IsMember({"auto", "x", "y", "z", "screen"}));
    command.add_flag("--volume-unshaded", volume_unshaded,
                     "Draw volumes without shading by the gradient of the array.");
    command
        .add_option("--volume-unit-length", volume_unit_length,
                    "Length after which a ray has the opacity given by --volume; by default a tenth of the diagonal.")
        ->type_name("LENGTH");
    command.add_flag("--edges", edges, "Draw the edges of the cells on all surfaces.");
    command
        .add_option("--contours", contours,
                    "Contour lines of a point scalar on slices, at the given values or at ten even values.")
        ->type_name("ARRAY[=VALUE,...]");
    command
        .add_option("--contour-map", contour_map,
                    "Color map of the contour lines; each line has the color of its value.")
        ->type_name("NAME");
    command
        .add_option("--clip", clips,
                    "Cut away everything beyond a plane, and close --surface with a cap; up to six planes. --clip=-x=1 "
                    "cuts away the other side of --clip x=1.")
        ->type_name("[-]x|y|z=VALUE or ox,oy,oz,nx,ny,nz");
}

void LayerOptions::shape_volumes(nlohmann::json& layers) const {
    const auto set = [&](const char* option, const char* member, const auto& value) {
        if (change(layers, is_volume, [&](auto& layer) { layer[member] = value; }) == 0)
            throw UsageError(std::string(option) + " applies to volumes only; give --volume");
    };
    if (volume_slices) set("--volume-slices", "slices", *volume_slices);
    if (volume_direction) set("--volume-direction", "direction", *volume_direction);
    if (volume_unshaded) set("--volume-unshaded", "shaded", false);
    if (!volume_unit_length) return;
    if (!(*volume_unit_length > 0) || !std::isfinite(*volume_unit_length))
        throw UsageError("--volume-unit-length must be a length of more than 0");
    set("--volume-unit-length", "unit_length", *volume_unit_length);
}

void LayerOptions::apply(nlohmann::json& layers) const {
    double order = static_cast<double>(layers.size());
    if (surface) layers["surface"] = {{"type", "surface"}, {"order", order++}};
    if (feature_edges) layers["edges"] = {{"type", "edges"}, {"order", order++}, {"angle", *feature_edges}};
    if (points) layers["points"] = {{"type", "points"}, {"order", order++}, {"of", *points}};
    if (threshold) {
        const nlohmann::json range = threshold_of(*threshold);
        if (change(layers, is_of_cells, [&](auto& layer) { layer["threshold"] = range; }) == 0)
            throw UsageError(
                "--threshold applies to surfaces, edges and points only; give --surface, --feature-edges or --points");
    }
    if (!patches.empty() && change(layers, is_of_cells, [&](auto& layer) { layer["groups"] = patches; }) == 0)
        throw UsageError("--patches applies to surfaces, edges and points of the boundary only; give --surface, "
                         "--feature-edges or --points");
    if (opacity && change(layers, has_opacity, [&](auto& layer) { layer["opacity"] = *opacity; }) == 0)
        throw UsageError("--opacity has no layer to apply to; give --iso, --slice, --plane, --surface or --volume");
    if (flat && change(layers, is_iso, [](auto& layer) { layer["smooth"] = false; }) == 0)
        throw UsageError("--flat applies to iso-surfaces only; give --iso");
    shape_volumes(layers);
    if (edges && change(layers, has_polygons, [](auto& layer) { layer["edges"] = nlohmann::json::object(); }) == 0)
        throw UsageError("--edges has no surface to apply to; give --iso, --slice or --surface");
    for (std::size_t i = 0; i < clips.size(); ++i) layers["clip" + std::to_string(i + 1)] = clip_of(clips[i]);
    if (contours.empty() && !contour_map.empty())
        throw UsageError("--contour-map applies to contour lines only; give --contours");
    if (contours.empty()) return;
    nlohmann::json lines = contours_of(contours);
    if (!contour_map.empty()) check_map("--contour-map", contour_map);
    if (!contour_map.empty()) lines["coloring"] = {{"map", contour_map}};
    if (change(layers, is_slice, [&](auto& layer) { layer["contours"] = lines; }) == 0)
        throw UsageError("--contours applies to slices only; give --slice or --plane");
}

} // namespace server::app
