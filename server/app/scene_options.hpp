// Scene options of `ciel extract` and `ciel render`. They produce a scene document, so that the server's code makes the
// pictures and files.
#pragma once

#include "geometry/scene_geometry.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ciel::app {

// --algorithm and --decider of surface extraction.
struct ExtractionOptions {
    std::string algorithm = "signatures", decider = "isolate-high";

    void add_to(CLI::App& command);
    [[nodiscard]] Extraction chosen() const;
};

struct SceneOptions {
    std::string dataset;                                    // path of NAME.ciel
    std::vector<std::string> isos, slices, planes, volumes; // volumes: only of `ciel render`
    std::optional<double> time;
    ExtractionOptions extraction;

    void add_to(CLI::App& command);
    [[nodiscard]] bool has_layers() const {
        return !isos.empty() || !slices.empty() || !planes.empty() || !volumes.empty();
    }
    void check_time() const; // throws UsageError if `time` is not finite
    // Returns a scene with the chosen layers, without colors, at `time` or else at the first step. Throws UsageError on
    // a malformed option.
    [[nodiscard]] nlohmann::json document(const store::Dataset& dataset) const;
};

[[nodiscard]] std::shared_ptr<store::LoadedDataset> load_dataset(const std::string& path);
// Throws Error, with the path in the document, if the scene is invalid.
[[nodiscard]] scene::Scene parse_scene(const nlohmann::json& document);
[[nodiscard]] std::shared_ptr<const geometry::Geometry>
make_geometry(const scene::Scene& scene, const std::shared_ptr<store::LoadedDataset>& loaded, Extraction extraction);

// Returns the time of the step nearest to `time`. Prints a note to stderr if the two differ.
[[nodiscard]] double time_of_step(const store::Dataset& dataset, double time);

// Returns the extension in lower case: ".ply" for "Surface.PLY".
[[nodiscard]] std::string lower_case_extension(const std::string& file);

// Parses "a,b,c" as finite numbers. Throws UsageError naming the option.
[[nodiscard]] std::vector<double> parse_numbers(const std::string& option, const std::string& text);

} // namespace ciel::app
