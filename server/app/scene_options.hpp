// Turns options of `ciel extract` and `ciel render` into a scene document, so that both use the server's code.
#pragma once

#include "geometry/scene_geometry.hpp"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace server::app {

struct ExtractionOptions {
    std::string algorithm = "signatures", decider = "isolate-high";

    void add_to(CLI::App& command);
    [[nodiscard]] ciel::Extraction chosen() const;
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
    // Returns the scene document. It shows the step nearest to `time`, or the first step without `time`. Throws
    // UsageError on a malformed option.
    [[nodiscard]] nlohmann::json document(const store::Dataset& dataset) const;
};

[[nodiscard]] std::shared_ptr<store::LoadedDataset> load_dataset(const std::string& path);
// Throws Error if the scene is invalid; the error names the path of the invalid member in the document.
[[nodiscard]] scene::Scene parse_scene(const nlohmann::json& document);
// Reads all late arrays (not read from the source yet) of the scene's step. Shows progress on stderr. Throws Error.
void read_late_step(const scene::Scene& scene, store::LoadedDataset& loaded);

struct MadeGeometry {
    scene::CheckedScene checked;
    std::shared_ptr<const geometry::Geometry> geometry;
};
// Reads the late arrays of the scene's step if a layer needs one of them. Throws Error if the scene names something
// that the dataset does not have.
[[nodiscard]] MadeGeometry make_geometry(const scene::Scene& scene, const std::shared_ptr<store::LoadedDataset>& loaded,
                                         ciel::Extraction extraction);

// Returns `time` itself if the dataset has no steps. Prints a note to stderr if the result differs from `time`.
[[nodiscard]] double time_of_step(const store::Dataset& dataset, double time);

[[nodiscard]] std::string lower_case_extension(const std::string& file);

// Parses "a,b,c" as finite numbers. Throws UsageError on other text; the error names the option.
[[nodiscard]] std::vector<double> parse_numbers(const std::string& option, const std::string& text);

} // namespace server::app
