#include "app/lighting_options.hpp"

#include "app/commands.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace ciel::app {

void LightingOptions::add_to(CLI::App& command) {
    const auto strength = [&](const char* option, std::optional<double>& value, const char* what) {
        command.add_option(option, value, what)->type_name("STRENGTH");
    };
    command.add_flag("--unlit", unlit, "All in its own colors, without light and shade.");
    strength("--headlight", headlight, "Of the light at the eye; 0: off, 1 by default.");
    strength("--key-light", key_light, "Of the light over the viewer's left shoulder; 0: off, 1 by default.");
    strength("--ambient", ambient, "Of the light from everywhere; 1 by default.");
    command.add_flag("--ambient-occlusion", ambient_occlusion,
                     "Darker opaque surfaces where others near them keep out light from everywhere.");
    command
        .add_option("--occlusion-radius", occlusion_radius,
                    "How near, as a share of the diagonal of the bounds; 0.1 by default.")
        ->type_name("SHARE");
    strength("--occlusion-strength", occlusion_strength, "How dark; 1 by default.");
}

nlohmann::json LightingOptions::patch() const {
    nlohmann::json lighting = nlohmann::json::object();
    if (unlit) lighting["on"] = false;
    if (ambient) lighting["ambient"] = *ambient;
    const auto light = [&](const char* name, const std::optional<double>& strength) {
        if (strength) lighting[name] = {{"on", *strength != 0}, {"strength", *strength}};
    };
    light("headlight", headlight);
    light("key_light", key_light);
    if (!ambient_occlusion && (occlusion_radius || occlusion_strength))
        throw UsageError("--occlusion-radius and --occlusion-strength go with --ambient-occlusion");
    if (ambient_occlusion) {
        nlohmann::json& occlusion = lighting["ambient_occlusion"] = {{"on", true}};
        if (occlusion_radius) occlusion["radius"] = *occlusion_radius;
        if (occlusion_strength) occlusion["strength"] = *occlusion_strength;
    }
    if (lighting.empty()) return lighting;
    return {{"lighting", std::move(lighting)}};
}

} // namespace ciel::app
