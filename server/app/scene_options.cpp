#include "app/scene_options.hpp"

#include "app/commands.hpp"
#include "app/import_folder.hpp"
#include "app/import_view.hpp"
#include "ciel/printable.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <utility>

namespace server::app {
namespace {

constexpr std::size_t field_cache_bytes = std::size_t{1} << 30;

// Splits at the last '=', because an array name may contain '=' and a value cannot.
std::pair<std::string, std::string> split_assignment(const std::string& option, const std::string& text,
                                                     const char* form) {
    const auto equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
        throw UsageError(option + " " + text + " is not of the form " + form);
    return {text.substr(0, equals), text.substr(equals + 1)};
}

nlohmann::json iso_layer(const std::string& text) {
    const auto [array, values] = split_assignment("--iso", text, "ARRAY=VALUE[,VALUE...]");
    return {{"type", "iso"}, {"array", array}, {"values", parse_numbers("--iso", values)}};
}

nlohmann::json slice_layer(const std::string& text) {
    const auto [axis, value] = split_assignment("--slice", text, "x=VALUE, y=VALUE or z=VALUE");
    const std::vector<double> numbers = parse_numbers("--slice", value);
    if ((axis != "x" && axis != "y" && axis != "z") || numbers.size() != 1)
        throw UsageError("--slice " + text + " is not of the form x=VALUE, y=VALUE or z=VALUE");
    return {{"type", "slice"}, {"axis", axis}, {"value", numbers[0]}};
}

nlohmann::json plane_layer(const std::string& text) {
    const std::vector<double> n = parse_numbers("--plane", text);
    if (n.size() != 6)
        throw UsageError("--plane " + text + " needs six numbers: a point and a normal, ox,oy,oz,nx,ny,nz");
    if (std::hypot(n[3], n[4], n[5]) == 0)
        throw UsageError("--plane " + text + " has a normal of length zero; give a nonzero normal");
    return {{"type", "slice"}, {"origin", {n[0], n[1], n[2]}}, {"normal", {n[3], n[4], n[5]}}};
}

// `text`: ARRAY or ARRAY=POSITION:OPACITY,...
nlohmann::json volume_layer(const std::string& text) {
    const auto equals = text.rfind('=');
    nlohmann::json layer{{"type", "volume"}, {"array", text.substr(0, equals)}};
    if (equals == std::string::npos) return layer;
    std::string numbers = text.substr(equals + 1);
    const auto colons = std::ranges::count(numbers, ':');
    std::ranges::replace(numbers, ':', ',');
    const std::vector<double> pairs = parse_numbers("--volume", numbers);
    if (equals == 0 || pairs.size() != 2 * static_cast<std::size_t>(colons))
        throw UsageError("--volume " + text + " is not of the form ARRAY or ARRAY=POSITION:OPACITY[,...]");
    nlohmann::json& points = layer["opacity_points"] = nlohmann::json::array();
    for (std::size_t i = 0; i < pairs.size(); i += 2) points.push_back({pairs[i], pairs[i + 1]});
    return layer;
}

// Makes a layer wait for its late array, which make_geometry() then reads. The words are shown if it is still late
// then.
store::LateAnswer await_late_step(const store::Dataset& /*dataset*/, std::size_t /*step*/) {
    return {"has not been read from its source; use `ciel import --step`", false};
}

scene::CheckedScene check_scene(const scene::Scene& scene, const std::shared_ptr<store::LoadedDataset>& loaded) {
    try {
        return {scene, loaded};
    } catch (const scene::Invalid& error) {
        throw ciel::Error(ciel::printable(error.path) + ": " + error.what());
    }
}

} // namespace

void SceneOptions::add_to(CLI::App& command) {
    command.add_option("dataset", dataset, "The dataset, NAME.ciel.")->required()->type_name("NAME.ciel");
    command.add_option("--iso", isos, "Iso-surface of a point scalar at one or several values; may be repeated.")
        ->type_name("ARRAY=VALUE[,VALUE...]");
    command.add_option("--slice", slices, "Slice across an axis; may be repeated.")->type_name("x|y|z=VALUE");
    command.add_option("--plane", planes, "Slice through the point o with the normal n; may be repeated.")
        ->type_name("ox,oy,oz,nx,ny,nz");
    command
        .add_option("--time", time, "Time of the step to show; the step nearest to T is shown, by default the first.")
        ->type_name("T");
    extraction.add_to(command);
}

void ExtractionOptions::add_to(CLI::App& command) {
    const CLI::IsMember known({"signatures", "propagation"});
    // Version 0.4 removes --engine. It is added first, because options are read in this order and the last one counts.
    command.add_option("--engine", algorithm)->check(known)->envname("CIEL_ENGINE")->group("");
    command.add_option("--algorithm", algorithm, "Algorithm of the surface extraction; also CIEL_ALGORITHM.")
        ->check(known)
        ->envname("CIEL_ALGORITHM")
        ->capture_default_str();
    command.add_option("--decider", decider, "Rule that joins the points on ambiguous faces.")
        ->check(CLI::IsMember({"isolate-high", "asymptotic"}))
        ->capture_default_str();
}

ciel::Extraction ExtractionOptions::chosen() const {
    return {algorithm == "propagation" ? ciel::Algorithm::propagation : ciel::Algorithm::signatures,
            decider == "asymptotic" ? ciel::Decider::asymptotic : ciel::Decider::isolate_high};
}

void SceneOptions::check_time() const {
    if (time && !std::isfinite(*time)) throw UsageError("--time must be a finite number");
}

nlohmann::json SceneOptions::document(const store::Dataset& loaded) const {
    nlohmann::json layers = nlohmann::json::object();
    double order = 0;
    const auto add = [&](const char* kind, const std::vector<std::string>& texts, auto layer_of) {
        for (std::size_t i = 0; i < texts.size(); ++i) {
            nlohmann::json layer = layer_of(texts[i]);
            layer["order"] = order++;
            layers[kind + std::to_string(i + 1)] = std::move(layer);
        }
    };
    add("iso", isos, iso_layer);
    add("slice", slices, slice_layer);
    add("plane", planes, plane_layer);
    add("volume", volumes, volume_layer);
    nlohmann::json document{{"dataset", loaded.info().name}, {"layers", std::move(layers)}};
    check_time();
    if (time)
        document["time"] = time_of_step(loaded, *time);
    else if (!loaded.steps().empty())
        document["time"] = loaded.steps().front().time;
    return document;
}

std::shared_ptr<store::LoadedDataset> load_dataset(const std::string& path) {
    return std::make_shared<store::LoadedDataset>(store::Dataset::open(path, store::LackingRanges::computed,
                                                                       std::nullopt,
                                                                       late_folder_in(default_import_folder())),
                                                  field_cache_bytes, await_late_step);
}

scene::Scene parse_scene(const nlohmann::json& document) {
    try {
        return scene::parse(document);
    } catch (const scene::Invalid& error) {
        const std::string reason = error.what(); // a schema error already begins with the path
        const std::string path = ciel::printable(error.path);
        throw ciel::Error("the scene cannot be shown: " + (reason.starts_with(path) ? "" : path + ": ") + reason);
    }
}

void read_late_step(const scene::Scene& scene, store::LoadedDataset& loaded) {
    const auto dataset = loaded.dataset();
    if (dataset->steps().empty()) return;
    const std::size_t step = dataset->step_at(scene.time);
    if (dataset->late_chunks(step).empty()) return;
    ImportView view(stderr);
    const CancelOnSignal signals;
    importing::ImportLimits limits;
    limits.memory_option += " of 'ciel import'";
    limits.stalled_option += " of 'ciel import'";
    const importing::ImportEnd end =
        importing::run_import({{"inputs", {dataset->directory().string()}},
                               {"step", {std::to_string(step)}},
                               {"late-folder", {late_folder_in(default_import_folder()).string()}}},
                              limits, view.listener(), signals.cancelled());
    view.clear();
    if (!end.problem.empty()) throw ciel::Error(end.problem);
    (void)loaded.refresh();
}

MadeGeometry make_geometry(const scene::Scene& scene, const std::shared_ptr<store::LoadedDataset>& loaded,
                           ciel::Extraction extraction) {
    const auto make = [&] {
        scene::CheckedScene checked = check_scene(scene, loaded);
        auto geometry = geometry::SceneGeometry(extraction).update(checked);
        return MadeGeometry{std::move(checked), std::move(geometry)};
    };
    if (MadeGeometry made = make(); made.geometry->awaited.empty()) return made;
    read_late_step(scene, *loaded);
    return make();
}

double time_of_step(const store::Dataset& dataset, double time) {
    if (dataset.steps().empty()) return time;
    const double found = dataset.steps()[dataset.step_at(time)].time;
    if (std::abs(found - time) > 1e-6 * std::max(std::abs(found), std::abs(time)))
        std::cerr << "ciel: there is no step at time " << time << "; the nearest, " << found << ", is shown\n";
    return found;
}

std::string lower_case_extension(const std::string& file) {
    std::string extension = std::filesystem::path(file).extension().string();
    for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return extension;
}

std::vector<double> parse_numbers(const std::string& option, const std::string& text) {
    std::vector<double> numbers;
    if (text.empty()) throw UsageError(std::string(option).append(" needs a number"));
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        double number = 0;
        const auto [stop, problem] = std::from_chars(at, end, number);
        if (problem != std::errc{} || !std::isfinite(number) || (stop != end && *stop != ','))
            throw UsageError(std::string(option).append(" ").append(text).append(
                " holds a value that is not a finite number; give finite numbers with commas between them"));
        numbers.push_back(number);
        if (stop == end) return numbers;
        at = stop + 1;
    }
}

} // namespace server::app
