#include "store/format/marker.hpp"

#include "store/format/checksum.hpp"
#include "store/format/json_reader.hpp"
#include "store/format/layout.hpp"

namespace ciel::store {
namespace {

constexpr std::uint64_t most_meshes = 1'000'000;

std::array<double, 2> parse_range(const JsonReader& value) {
    const auto items = value.items();
    if (items.size() != 2) value.refuse("must be [lowest, highest]");
    return {items[0].number(), items[1].number()};
}

CellExtreme parse_extreme(const JsonReader& value) {
    CellExtreme extreme;
    const std::uint64_t cell = value.at("cell").count();
    if (cell >= none) value.at("cell").refuse("is larger than any cell's id");
    extreme.cell = static_cast<Index>(cell);
    const auto place = value.at("place").items();
    if (place.size() != 3) value.at("place").refuse("must be [x, y, z]");
    for (std::size_t axis = 0; axis < 3; ++axis) extreme.place[axis] = place[axis].number();
    return extreme;
}

std::optional<ArrayStep> parse_statistics(const JsonReader& value) {
    const auto range = value.find("range"), components = value.find("component_ranges");
    if (!range || !components) return std::nullopt;
    ArrayStep statistics;
    statistics.range = parse_range(*range);
    for (const JsonReader& item : components->items()) statistics.component_ranges.push_back(parse_range(item));
    if (const auto invalid = value.find("invalid")) statistics.invalid = invalid->count();
    if (const auto missing = value.find("missing")) statistics.missing = missing->count();
    if (const auto extremes = value.find("extremes"))
        for (const JsonReader& item : extremes->items())
            statistics.extremes.push_back({parse_extreme(item.at("lowest")), parse_extreme(item.at("highest"))});
    return statistics;
}

MarkedArray parse_array(const JsonReader& value, std::uint64_t default_chunk) {
    MarkedArray array;
    const auto chunk = value.find("chunk");
    array.chunk = chunk ? chunk->count() : default_chunk;
    if (const auto sum = value.find("checksum")) {
        array.checksum = sum->text();
        if (!is_checksum(array.checksum)) sum->refuse("must be \"xxh3:\" and 16 hexadecimal digits");
    }
    if (const auto lazy = value.find("lazy")) array.lazy = lazy->flag();
    array.statistics = parse_statistics(value);
    return array;
}

MarkedStep parse_step(const JsonReader& value, std::vector<std::uint64_t>& steps_on_mesh) {
    MarkedStep step;
    step.time = value.at("time").number();
    if (const auto mesh = value.find("mesh")) step.mesh = mesh->count();
    if (step.mesh >= steps_on_mesh.size())
        value.refuse("names mesh " + std::to_string(step.mesh) + ", but there are " +
                     std::to_string(steps_on_mesh.size()));
    if (const auto coordinates = value.find("coordinates")) step.coordinates = coordinates->count();
    const std::uint64_t default_chunk = steps_on_mesh[step.mesh]++;
    if (const auto arrays = value.find("arrays"))
        for (const auto& [name, array] : arrays->members())
            step.arrays.emplace(name, parse_array(array, default_chunk));
    return step;
}

nlohmann::json to_json(const CellExtreme& extreme) { return {{"cell", extreme.cell}, {"place", extreme.place}}; }

nlohmann::json to_json(const MarkedArray& array) {
    nlohmann::json json{{"chunk", array.chunk}};
    if (!array.checksum.empty()) json["checksum"] = array.checksum;
    if (array.lazy) json["lazy"] = true;
    if (array.statistics) {
        json["range"] = array.statistics->range;
        json["component_ranges"] = array.statistics->component_ranges;
        if (array.statistics->invalid > 0) json["invalid"] = array.statistics->invalid;
        if (array.statistics->missing > 0) json["missing"] = array.statistics->missing;
        for (const auto& [lowest, highest] : array.statistics->extremes)
            json["extremes"].push_back({{"lowest", to_json(lowest)}, {"highest", to_json(highest)}});
    }
    return json;
}

} // namespace

Marker parse_marker(std::string_view text, const std::filesystem::path& file) {
    const nlohmann::json json = parse_json(text, file);
    const JsonReader document(json, file);
    const JsonReader version = document.at("ciel_steps");
    if (version.count() != layout::format_version)
        version.refuse("is " + std::to_string(version.count()) + ", but the installed CIEL reads " +
                       std::to_string(layout::format_version) + "; update CIEL");
    Marker marker;
    marker.meshes = document.at("meshes").count();
    if (marker.meshes == 0 || marker.meshes > most_meshes) document.at("meshes").refuse("must be 1 to 1000000");
    std::vector<std::uint64_t> steps_on_mesh(marker.meshes);
    for (const JsonReader& item : document.at("steps").items()) {
        marker.steps.push_back(parse_step(item, steps_on_mesh));
        if (marker.steps.size() > 1 && !(marker.steps.back().time > marker.steps[marker.steps.size() - 2].time))
            item.refuse("is not later than the step before it");
    }
    return marker;
}

std::string to_text(const Marker& marker) {
    nlohmann::json steps = nlohmann::json::array();
    for (const MarkedStep& step : marker.steps) {
        nlohmann::json arrays = nlohmann::json::object();
        for (const auto& [name, array] : step.arrays) arrays[name] = to_json(array);
        steps.push_back({{"time", step.time},
                         {"mesh", step.mesh},
                         {"coordinates", step.coordinates},
                         {"arrays", std::move(arrays)}});
    }
    return to_text(
        nlohmann::json{{"ciel_steps", layout::format_version}, {"meshes", marker.meshes}, {"steps", std::move(steps)}});
}

} // namespace ciel::store
