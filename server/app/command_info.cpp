// ciel info: prints the contents of a dataset. Reads every chunk and thereby verifies every checksum.
#include "annotations/ticks.hpp"
#include "app/commands.hpp"
#include "app/import_folder.hpp"
#include "store/cell_extremes.hpp"
#include "store/dataset.hpp"
#include "store/mesh_counts.hpp"
#include "store/mesh_questions.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace server::app {
namespace {

using nlohmann::json;
using store::Dataset;

struct Checksums {
    std::uint64_t verified = 0, absent = 0, late = 0;
};

Checksums verify_all(const Dataset& dataset) {
    dataset.verify();
    Checksums sums;
    for (const store::Step& step : dataset.steps())
        for (const auto& [name, array] : step.arrays)
            ++(array.late ? sums.late : array.has_checksum ? sums.verified : sums.absent);
    return sums;
}

json mesh_json(const store::MeshInfo& mesh) {
    return {{"vertices", mesh.vertices},
            {"edges", mesh.edges},
            {"faces", mesh.faces},
            {"half_edges", mesh.half_edges},
            {"boundary_faces", mesh.boundary_faces},
            {"components", mesh.components},
            {"positions", mesh.double_positions ? "float64" : "float32"},
            {"cells", mesh.cells_by_type}};
}

// Uses the first step that stores values. Returns null if there is none, and for arrays that have no iso-surfaces.
json ambiguous_faces(const Dataset& dataset, const store::ArrayInfo& array) {
    if (array.components > 1 || array.association != store::Association::point) return nullptr;
    for (std::size_t step = 0; step < dataset.steps().size(); ++step) {
        const store::Step& at = dataset.steps()[step];
        if (const auto found = at.arrays.find(array.name); found != at.arrays.end() && !found->second.late)
            return store::count_ambiguous_faces(dataset, at, dataset.values(array.name, step));
    }
    return nullptr;
}

json extreme_json(const store::CellValue& found) {
    return {{"value", found.value}, {"cell", found.cell}, {"place", found.place}, {"time", found.time}};
}

json array_json(const Dataset& dataset, const store::ArrayInfo& array) {
    json times = json::array(), range;
    std::uint64_t invalid = 0, missing = 0;
    for (const store::Step& step : dataset.steps()) {
        const auto found = step.arrays.find(array.name);
        if (found == step.arrays.end()) continue;
        times.push_back(step.time);
        invalid += found->second.invalid;
        missing += found->second.missing;
        if (found->second.late) continue;
        const auto& [low, high] = found->second.range;
        range = range.is_null() ? json{low, high}
                                : json{std::min(low, range[0].get<double>()), std::max(high, range[1].get<double>())};
    }
    const auto extremes = store::range_extremes(dataset, array);
    return {{"name", array.name},
            {"association", store::to_text(array.association)},
            {"component_names", array.component_names},
            {"origin", store::to_text(array.source.origin)},
            {"type", array.source.type},
            {"stored", array.doubles ? "float64" : "float32"},
            {"file", array.source.file},
            {"extremes",
             extremes ? json{{"lowest", extreme_json(extremes->lowest)}, {"highest", extreme_json(extremes->highest)}}
                      : json()},
            {"components", array.components},
            {"range", range},
            {"invalid", invalid},
            {"units", array.units},
            {"description", array.description},
            {"times", times},
            {"missing", missing},
            {"missing_steps", dataset.steps().size() - times.size()},
            {"ambiguous_faces", ambiguous_faces(dataset, array)}};
}

json solver_ids_json(const Dataset& dataset) {
    json of = json::array();
    if (!dataset.solver_vertex(0).empty()) of.push_back("vertices");
    if (!dataset.solver_cell(0).empty()) of.push_back("cells");
    return of;
}

json groups_json(const Dataset& dataset) {
    json groups = json::array();
    for (const store::Group& group : dataset.groups(0))
        groups.push_back({{"name", group.name},
                          {"of", group.of == store::Group::Of::faces ? "faces" : "cells"},
                          {"count", group.ids.size()},
                          {"type", group.facts.type},
                          {"conditions", group.facts.conditions}});
    return groups;
}

json report(const Dataset& dataset) {
    const store::DatasetInfo& info = dataset.info();
    const Checksums sums = verify_all(dataset);
    const std::uint64_t topology_bytes = store::record_bytes(dataset.topology(0));
    json arrays = json::array(), meshes = json::array(), times = json::array();
    for (const store::ArrayInfo& array : info.arrays) arrays.push_back(array_json(dataset, array));
    for (const store::MeshInfo& mesh : info.meshes) meshes.push_back(mesh_json(mesh));
    for (const double time : dataset.steps().times()) times.push_back(time);
    return {{"name", info.name},
            {"format_version", info.format_version},
            {"source", info.source},
            {"created", info.created},
            {"length_units", info.length_units},
            {"notes", info.notes},
            {"input", {{"vertices", info.input_vertices}, {"edges", info.input_edges}, {"cells", info.input_cells}}},
            {"mesh", meshes[0]},
            {"meshes", meshes},
            {"groups", groups_json(dataset)},
            {"solver_ids", solver_ids_json(dataset)},
            {"bounds", info.meshes[0].bounds},
            {"times", times},
            {"arrays", arrays},
            {"memory",
             {{"topology_bytes", topology_bytes},
              {"stored_blocks", dataset.block_boxes(0, 0).has_value()},
              {"bytes_per_half_edge",
               static_cast<double>(topology_bytes) / static_cast<double>(info.meshes[0].half_edges)}}},
            {"checksums",
             {{"algorithm", "xxh3-64"},
              {"topology", "verified"},
              {"verified", sums.verified},
              {"without_checksum", sums.absent},
              {"late", sums.late}}}};
}

// Returns, for example, ", wall: U noSlip, p zeroGradient".
std::string facts_of(const json& group) {
    std::string text;
    for (const auto& [array, condition] : group["conditions"].items())
        text += (text.empty() ? ": " : ", ") + array + " " + condition.get<std::string>();
    const std::string type = group["type"];
    return type.empty() ? "" : ", " + type + text;
}

std::string grouped(const json& number) {
    std::string digits = std::to_string(number.get<std::uint64_t>());
    for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<std::size_t>(at), 1, ',');
    return digits;
}

std::string number(const json& value, int digits = 6) {
    std::ostringstream text;
    text << std::setprecision(digits) << value.get<double>();
    return text.str();
}

std::string range_text(const json& range) {
    const int digits = annotations::digits_of_range(range[0], range[1]);
    return "[" + number(range[0], digits) + ", " + number(range[1], digits) + "]";
}

void line(const std::string& label, const std::string& text) {
    std::cout << "  " << std::left << std::setw(17) << label << ' ' << text << '\n';
}

void print_counts(const json& mesh) {
    for (const char* key : {"vertices", "edges", "faces", "half_edges", "boundary_faces", "components"})
        line(key, grouped(mesh[key]));
    line("positions", mesh["positions"]);
    for (const auto& [type, count] : mesh["cells"].items()) line(type, grouped(count));
}

// Returns, for example, "original int32 from 0/p, stored as float64".
std::string source_of(const json& array) {
    const std::string type = array["type"], stored = array["stored"];
    std::string text = array["origin"];
    if (!type.empty()) text += " " + type;
    if (const std::string file = array["file"]; !file.empty()) text += " from " + file;
    if (!type.empty() && type != stored) text += ", stored as " + stored;
    return text;
}

std::string describe(const json& array) {
    std::ostringstream text;
    text << std::left << std::setw(14) << array["association"].get<std::string>() << "x"
         << array["components"].get<int>() << "  ";
    if (!array["range"].is_null()) text << range_text(array["range"]) << ' ';
    text << array["units"].get<std::string>() << "  at " << array["times"].size() << " times";
    if (array["missing_steps"] > 0) text << ", missing at " << array["missing_steps"];
    if (!array["ambiguous_faces"].is_null()) text << ", " << grouped(array["ambiguous_faces"]) << " ambiguous faces";
    if (array["missing"] > 0) text << ", " << grouped(array["missing"]) << " values missing";
    if (array["invalid"] > 0) text << ", " << grouped(array["invalid"]) << " values not finite";
    text << "; " << source_of(array);
    return text.str();
}

std::string extreme_text(const json& found) {
    std::string text =
        number(found["value"]) + " in cell " + std::to_string(found["cell"].get<std::uint64_t>()) + " at (";
    for (std::size_t axis = 0; axis < 3; ++axis) text += (axis > 0 ? ", " : "") + number(found["place"][axis]);
    return text + "), time " + number(found["time"]);
}

void print_array(const json& array) {
    line(array["name"], describe(array));
    if (array["association"] != "cell" || array["extremes"].is_null()) return;
    line("", "lowest " + extreme_text(array["extremes"]["lowest"]));
    line("", "highest " + extreme_text(array["extremes"]["highest"]));
}

std::string all_digits(double value) {
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

void print(const json& info) {
    std::cout << info["name"].get<std::string>() << '\n';
    line("source", info["source"]);
    line("created", info["created"]);
    for (const json& note : info["notes"]) line("note", note);
    std::cout << "input\n";
    for (const char* key : {"vertices", "edges", "cells"}) line(key, grouped(info["input"][key]));
    for (std::size_t m = 0; m < info["meshes"].size(); ++m) {
        std::cout << "mesh" << (info["meshes"].size() > 1 ? " " + std::to_string(m) : "") << '\n';
        print_counts(info["meshes"][m]);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
        line(std::string(1, "xyz"[axis]), "[" + all_digits(info["bounds"][2 * axis]) + ", " +
                                              all_digits(info["bounds"][2 * axis + 1]) + "] " +
                                              info["length_units"].get<std::string>());
    if (!info["groups"].empty()) std::cout << "groups\n";
    for (const json& group : info["groups"])
        line(group["name"], grouped(group["count"]) + " " + group["of"].get<std::string>() + facts_of(group));
    for (const json& of : info["solver_ids"])
        line("ids", "the " + of.get<std::string>() + " also have the ids of the solver");
    std::cout << "arrays\n";
    for (const json& array : info["arrays"]) print_array(array);
    if (!info["times"].empty()) {
        std::cout << "times\n";
        line(grouped(info["times"].size()),
             "from " + number(info["times"].front()) + " to " + number(info["times"].back()));
    }
    std::cout << "memory\n";
    line("topology", grouped(info["memory"]["topology_bytes"]) + " bytes, " +
                         number(info["memory"]["bytes_per_half_edge"]) + " per half-edge");
    if (!info["memory"]["stored_blocks"])
        line("blocks",
             "none: each opening builds the topology; write the dataset again, with blocks, with `ciel import " +
                 info["name"].get<std::string>() + ".ciel -o NEW.ciel`");
    const json& sums = info["checksums"];
    std::cout << "checksums\n";
    line("topology", "verified");
    line("values", grouped(sums["verified"]) + " chunks verified, " + grouped(sums["without_checksum"]) +
                       " without checksum, " + grouped(sums["late"]) + " not yet read from the source");
}

} // namespace

void add_info(CLI::App& app, Run& run) {
    struct Options {
        std::string dataset;
        bool as_json = false;
    };
    const auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("info", "Print the contents of a dataset, and verify all its checksums.");
    command->add_option("dataset", options->dataset, "NAME.ciel")->required();
    command->add_flag("--json", options->as_json,
                      "Print JSON; ambiguous_faces is counted at the first time of each array");
    command->callback([options, &run] {
        run = [options] {
            const json info = report(*Dataset::open(options->dataset, store::LackingRanges::computed, std::nullopt,
                                                    late_folder_in(default_import_folder())));
            if (options->as_json)
                std::cout << info.dump(2) << '\n';
            else
                print(info);
            return 0;
        };
    });
}

} // namespace server::app
