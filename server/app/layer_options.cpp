#include "app/layer_options.hpp"

#include "app/color_options.hpp"
#include "app/commands.hpp"
#include "app/scene_options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ciel::app {
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

// Calls make on each wanted layer. Returns their number.
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

// `text`: "p" or "p=1,2,3". Splits at the last '=': an array name may contain one.
nlohmann::json contours_of(const std::string& text) {
    const auto equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0) return {{"array", text}};
    return {{"array", text.substr(0, equals)}, {"values", parse_numbers("--contours", text.substr(equals + 1))}};
}

constexpr const char* clip_form =
    " is not of the form x=VALUE, y=VALUE or z=VALUE, with a - before it for the other side, or ox,oy,oz,nx,ny,nz";

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
                    "Edges at which the boundary bends by more than so many degrees; 0 for all that bend.")
        ->type_name("DEGREES");
    command.add_option("--points", points, "Vertices of the boundary, or all.")
        ->check(CLI::IsMember({"boundary", "all"}));
    command
        .add_option(
            "--threshold", threshold,
            "Only cells whose vertices all have a value in this range, or who have one themselves where the array is "
            "of the cells: of --surface, --feature-edges and --points.")
        ->type_name("ARRAY=MIN,MAX");
    command.add_option("--patches", patches, "Of these patches: --surface, --feature-edges and --points boundary.")
        ->type_name("NAME[,NAME...]")
        ->delimiter(',');
    command.add_option("--opacity", opacity, "Of all layers, from 0 to 1.")->type_name("SHARE");
    command.add_flag("--flat", flat, "Iso-surfaces shaded polygon by polygon, not by the field's gradient.");
    command
        .add_option("--volume-slices", volume_slices,
                    "How finely volumes are cut; 200 or more slices by default, as the mesh and the opacities need.")
        ->type_name("N");
    command
        .add_option(
            "--volume-direction", volume_direction,
            "What volumes are cut across: an axis, or the view's own direction (screen); auto, the axis nearest "
            "to the view, by default.")
        ->check(CLI::IsMember({"auto", "x", "y", "z", "screen"}));
    command.add_flag("--volume-unshaded", volume_unshaded, "Volumes without light and shade by the array's gradient.");
    command
        .add_option("--volume-unit-length", volume_unit_length,
                    "The length after which a ray has the opacity that --volume gives; a tenth of the diagonal by "
                    "default.")
        ->type_name("LENGTH");
    command.add_flag("--edges", edges, "Lines along the edges of all polygons: those of the cells.");
    command.add_option("--contours", contours, "Contour lines of a point scalar on slices: ten, or at these values.")
        ->type_name("ARRAY[=VALUE,...]");
    command.add_option("--contour-map", contour_map, "Each contour line in the color of its value on this map.")
        ->type_name("NAME");
    command
        .add_option("--clip", clips,
                    "Cut away what lies beyond a plane, with a cap where --surface is cut open; up to six. "
                    "--clip=-x=1 takes the other side of --clip x=1.")
        ->type_name("[-]x|y|z=VALUE or ox,oy,oz,nx,ny,nz");
}

void LayerOptions::shape_volumes(nlohmann::json& layers) const {
    const auto set = [&](const char* option, const char* member, const auto& value) {
        if (change(layers, is_volume, [&](auto& layer) { layer[member] = value; }) == 0)
            throw UsageError(std::string(option) + " is about volumes; give --volume");
    };
    if (volume_slices) set("--volume-slices", "slices", *volume_slices);
    if (volume_direction) set("--volume-direction", "direction", *volume_direction);
    if (volume_unshaded) set("--volume-unshaded", "shaded", false);
    if (!volume_unit_length) return;
    if (!(*volume_unit_length > 0) || !std::isfinite(*volume_unit_length))
        throw UsageError("--volume-unit-length is a length of more than 0");
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
            throw UsageError("--threshold chooses cells; give --surface, --feature-edges or --points");
    }
    if (!patches.empty() && change(layers, is_of_cells, [&](auto& layer) { layer["groups"] = patches; }) == 0)
        throw UsageError("--patches chooses parts of the boundary; give --surface, --feature-edges or --points");
    if (opacity && change(layers, has_opacity, [&](auto& layer) { layer["opacity"] = *opacity; }) == 0)
        throw UsageError("--opacity has nothing to work on; give --iso, --slice, --plane, --surface or --volume");
    if (flat && change(layers, is_iso, [](auto& layer) { layer["smooth"] = false; }) == 0)
        throw UsageError("--flat is about iso-surfaces; give --iso");
    shape_volumes(layers);
    if (edges && change(layers, has_polygons, [](auto& layer) { layer["edges"] = nlohmann::json::object(); }) == 0)
        throw UsageError("nothing has polygons whose edges could be drawn; give --iso, --slice or --surface");
    for (std::size_t i = 0; i < clips.size(); ++i) layers["clip" + std::to_string(i + 1)] = clip_of(clips[i]);
    if (contours.empty() && !contour_map.empty())
        throw UsageError("--contour-map colors contour lines; give --contours");
    if (contours.empty()) return;
    nlohmann::json lines = contours_of(contours);
    if (!contour_map.empty()) check_map("--contour-map", contour_map);
    if (!contour_map.empty()) lines["coloring"] = {{"map", contour_map}};
    if (change(layers, is_slice, [&](auto& layer) { layer["contours"] = lines; }) == 0)
        throw UsageError("contour lines are drawn on slices; give --slice or --plane");
}

} // namespace ciel::app
