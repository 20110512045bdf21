// What `ciel extract` and `ciel render` are asked to show, as options; the result is a scene document, so that pictures
// and files are made the way the server makes them.
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

// --algorithm and --decider: how surfaces are made.
struct ExtractionOptions {
    std::string algorithm = "signatures", decider = "isolate-high";

    void add_to(CLI::App& command);
    [[nodiscard]] Extraction chosen() const;
};

struct SceneOptions {
    std::string dataset;                                    // path of NAME.ciel
    std::vector<std::string> isos, slices, planes, volumes; // volumes: of `ciel render` alone
    std::optional<double> time;
    ExtractionOptions extraction;

    void add_to(CLI::App& command);
    [[nodiscard]] bool has_layers() const {
        return !isos.empty() || !slices.empty() || !planes.empty() || !volumes.empty();
    }
    void check_time() const; // throws UsageError where it is no finite number
    // The layers without colors, at the asked time or else at the first step. Throws UsageError on an option that
    // cannot be read.
    [[nodiscard]] nlohmann::json document(const store::Dataset& dataset) const;
};

[[nodiscard]] std::shared_ptr<store::LoadedDataset> load_dataset(const std::string& path);
// Throws Error with the place in the document when it cannot be shown.
[[nodiscard]] scene::Scene parse_scene(const nlohmann::json& document);
[[nodiscard]] std::shared_ptr<const geometry::Geometry>
make_geometry(const scene::Scene& scene, const std::shared_ptr<store::LoadedDataset>& loaded, Extraction extraction);

// The time of the step nearest to `time`; says so on stderr where it is another one.
[[nodiscard]] double time_of_step(const store::Dataset& dataset, double time);

// ".ply" of "Surface.PLY".
[[nodiscard]] std::string lower_case_extension(const std::string& file);

// "a,b,c" as finite numbers. Throws UsageError naming the option.
[[nodiscard]] std::vector<double> parse_numbers(const std::string& option, const std::string& text);

} // namespace ciel::app
