#include "store/format/marker.hpp"

#include "store/format/checksum.hpp"
#include "store/format/json_reader.hpp"

namespace server::store {
namespace {

constexpr std::uint64_t most_meshes = 1'000'000;
constexpr std::uint64_t most_table_steps = 100'000'000;
// Version 2 has a table of steps, which a reader of version 1 would not see. That reader must refuse the dataset.
constexpr std::uint64_t plain_version = 1, table_version = 2;

std::array<double, 2> parse_range(const JsonReader& value) {
    const auto items = value.items();
    if (items.size() != 2) value.refuse_damage("must be [lowest, highest]");
    return {items[0].number(), items[1].number()};
}

CellExtreme parse_extreme(const JsonReader& value) {
    CellExtreme extreme;
    const std::uint64_t cell = value.at("cell").count();
    if (cell >= ciel::none) value.at("cell").refuse_damage("is larger than any cell's id");
    extreme.cell = static_cast<ciel::Index>(cell);
    const auto place = value.at("place").items();
    if (place.size() != 3) value.at("place").refuse_damage("must be [x, y, z]");
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
        if (!is_checksum(array.checksum)) sum->refuse_damage("must be \"xxh3:\" and 16 hexadecimal digits");
    }
    if (const auto late = value.find("lazy")) array.late = late->flag();
    array.statistics = parse_statistics(value);
    return array;
}

MarkedStep parse_step(const JsonReader& value, std::vector<std::uint64_t>& next_chunk) {
    MarkedStep step;
    step.time = value.at("time").number();
    if (const auto mesh = value.find("mesh")) step.mesh = mesh->count();
    if (step.mesh >= next_chunk.size())
        value.refuse_damage("is on mesh " + std::to_string(step.mesh) + ", but the number of meshes is " +
                            std::to_string(next_chunk.size()));
    if (const auto coordinates = value.find("coordinates")) step.coordinates = coordinates->count();
    const std::uint64_t default_chunk = next_chunk[step.mesh]++;
    if (const auto arrays = value.find("arrays"))
        for (const auto& [name, array] : arrays->members())
            step.arrays.emplace(name, parse_array(array, default_chunk));
    return step;
}

nlohmann::json to_json(const CellExtreme& extreme) { return {{"cell", extreme.cell}, {"place", extreme.place}}; }

nlohmann::json to_json(const MarkedArray& array) {
    nlohmann::json json{{"chunk", array.chunk}};
    if (!array.checksum.empty()) json["checksum"] = array.checksum;
    if (array.late) json["lazy"] = true;
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

TableFacts parse_table(const JsonReader& value, std::uint64_t meshes) {
    TableFacts table;
    table.steps = value.at("steps").count();
    const JsonReader sum = value.at("checksum");
    table.checksum = sum.text();
    if (!is_checksum(table.checksum)) sum.refuse_damage("must be \"xxh3:\" and 16 hexadecimal digits");
    for (const JsonReader& item : value.at("arrays").items()) {
        TableArray& array = table.arrays.emplace_back(TableArray{item.at("name").text(), {}});
        for (const JsonReader& mesh : item.at("meshes").items()) {
            array.meshes.push_back(mesh.count());
            if (array.meshes.back() >= meshes) mesh.refuse_damage("is not the number of a mesh of the dataset");
        }
    }
    for (const JsonReader& chunks : value.at("chunks").items()) table.chunks.push_back(chunks.count());
    if (table.steps == 0 || table.steps > most_table_steps) value.at("steps").refuse_damage("must be 1 to 100000000");
    if (table.chunks.size() > meshes) value.at("chunks").refuse_damage("has more entries than there are meshes");
    return table;
}

nlohmann::json to_json(const TableFacts& table) {
    nlohmann::json arrays = nlohmann::json::array();
    for (const TableArray& array : table.arrays) arrays.push_back({{"name", array.name}, {"meshes", array.meshes}});
    return {
        {"steps", table.steps}, {"checksum", table.checksum}, {"arrays", std::move(arrays)}, {"chunks", table.chunks}};
}

} // namespace

Marker parse_marker(std::string_view text, const std::filesystem::path& file) {
    const nlohmann::json json = parse_json(text, file);
    const JsonReader document(json, file);
    const JsonReader version = document.at("ciel_steps");
    if (version.count() < plain_version || version.count() > table_version)
        version.refuse("is " + std::to_string(version.count()) + ", but the installed CIEL reads " +
                       std::to_string(plain_version) + " and " + std::to_string(table_version) + "; update CIEL");
    Marker marker;
    marker.meshes = document.at("meshes").count();
    if (marker.meshes == 0 || marker.meshes > most_meshes) document.at("meshes").refuse_damage("must be 1 to 1000000");
    if (const auto table = document.find("table")) {
        if (version.count() < table_version) version.refuse_damage("must be 2, because there is a table of steps");
        marker.table = parse_table(*table, marker.meshes);
    }
    std::vector<std::uint64_t> next_chunk = marker.table.chunks;
    next_chunk.resize(marker.meshes);
    for (const JsonReader& item : document.at("steps").items()) {
        marker.steps.push_back(parse_step(item, next_chunk));
        if (marker.steps.size() > 1 && !(marker.steps.back().time > marker.steps[marker.steps.size() - 2].time))
            item.refuse_damage("is not later than the step before it");
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
    const bool has_table = marker.table.steps > 0;
    nlohmann::json document{{"ciel_steps", has_table ? table_version : plain_version},
                            {"meshes", marker.meshes},
                            {"steps", std::move(steps)}};
    if (has_table) document["table"] = to_json(marker.table);
    return to_text(document);
}

std::optional<MarkedArray> parse_late_facts(std::string_view text, const std::filesystem::path& file,
                                            std::uint64_t chunk) {
    const nlohmann::json json = parse_json(text, file);
    const JsonReader document(json, file);
    if (const auto absent = document.find("absent"); absent && absent->flag()) return std::nullopt;
    MarkedArray array = parse_array(document, chunk);
    if (array.chunk != chunk || array.late) document.refuse_damage("must describe chunk " + std::to_string(chunk));
    return array;
}

std::string late_facts_text(const std::optional<MarkedArray>& array) {
    return to_text(array ? to_json(*array) : nlohmann::json{{"absent", true}});
}

} // namespace server::store
