#include "app/lighting_options.hpp"

#include "app/commands.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

namespace server::app {

void LightingOptions::add_to(CLI::App& command) {
    const auto strength = [&](const char* option, std::optional<double>& value, const char* what) {
        command.add_option(option, value, what)->type_name("STRENGTH");
    };
    command.add_flag("--unlit", unlit, "Draw all surfaces in plain colors, without lighting.");
    strength("--headlight", headlight, "Strength of the light at the camera; 0: off, 1 by default.");
    strength("--key-light", key_light, "Strength of the light over the viewer's left shoulder; 0: off, 1 by default.");
    strength("--ambient", ambient, "Strength of the ambient light; 1 by default.");
    command.add_flag("--ambient-occlusion", ambient_occlusion,
                     "Darken opaque surfaces where other surfaces near them block the ambient light.");
    command
        .add_option("--occlusion-radius", occlusion_radius,
                    "Radius of the ambient occlusion as a share of the diagonal of the bounds; 0.1 by default.")
        ->type_name("SHARE");
    strength("--occlusion-strength", occlusion_strength, "Strength of the ambient occlusion; 1 by default.");
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
        throw UsageError(
            "--occlusion-radius and --occlusion-strength apply to ambient occlusion only; give --ambient-occlusion");
    if (ambient_occlusion) {
        nlohmann::json& occlusion = lighting["ambient_occlusion"] = {{"on", true}};
        if (occlusion_radius) occlusion["radius"] = *occlusion_radius;
        if (occlusion_strength) occlusion["strength"] = *occlusion_strength;
    }
    if (lighting.empty()) return lighting;
    return {{"lighting", std::move(lighting)}};
}

} // namespace server::app
