#include "store/format/attributes.hpp"

#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/format/json_reader.hpp"
#include "store/format/layout.hpp"

#include <algorithm>

namespace server::store {
namespace {

std::string text_or_empty(const JsonReader& object, const char* key) {
    const auto value = object.find(key);
    return value ? value->text() : std::string();
}

struct AssociationName {
    Association association;
    const char* name;
};
constexpr std::array association_names{AssociationName{Association::point, "point"},
                                       AssociationName{Association::cell, "cell"},
                                       AssociationName{Association::boundary_face, "boundary_face"}};

Association parse_association(const JsonReader& value) {
    const std::string text = value.text();
    for (const auto& [association, name] : association_names)
        if (text == name) return association;
    value.refuse_damage("must be \"point\", \"cell\" or \"boundary_face\"");
}

struct OriginName {
    Origin origin;
    const char* name;
};
constexpr std::array origin_names{OriginName{Origin::unknown, "unknown"}, OriginName{Origin::original, "original"},
                                  OriginName{Origin::interpolated, "interpolated"},
                                  OriginName{Origin::derived, "derived"}};

Origin parse_origin(const JsonReader& value) {
    const std::string text = value.text();
    for (const auto& [origin, name] : origin_names)
        if (text == name) return origin;
    value.refuse_damage("must be \"unknown\", \"original\", \"interpolated\" or \"derived\"");
}

std::vector<std::string> parse_component_names(const JsonReader& value, std::uint64_t components) {
    std::vector<std::string> names;
    for (const JsonReader& name : value.items()) names.push_back(name.text());
    if (names.size() != components) value.refuse_damage("must have one name per component");
    return names;
}

std::string parse_checksum(const JsonReader& value) {
    std::string sum = value.text();
    if (!is_checksum(sum)) value.refuse_damage("must be \"xxh3:\" and 16 hexadecimal digits");
    return sum;
}

template <std::size_t N>
std::array<double, N> parse_numbers(const JsonReader& value) {
    const auto items = value.items();
    if (items.size() != N) value.refuse_damage("must hold " + std::to_string(N) + " numbers");
    std::array<double, N> numbers{};
    for (std::size_t i = 0; i < N; ++i) numbers[i] = items[i].number();
    return numbers;
}

GroupName parse_group(const JsonReader& value) {
    const std::string of = value.at("of").text();
    if (of != "faces" && of != "cells") value.at("of").refuse_damage("must be \"faces\" or \"cells\"");
    GroupName group{of == "faces" ? Group::Of::faces : Group::Of::cells, value.at("name").text()};
    if (const auto type = value.find("type")) group.facts.type = type->text();
    if (const auto conditions = value.find("conditions"))
        for (const auto& [array, condition] : conditions->members()) group.facts.conditions[array] = condition.text();
    return group;
}

nlohmann::json to_json(const GroupName& group) {
    nlohmann::json value{{"of", group.of == Group::Of::faces ? "faces" : "cells"}, {"name", group.name}};
    if (!group.facts.type.empty()) value["type"] = group.facts.type;
    if (!group.facts.conditions.empty()) value["conditions"] = group.facts.conditions;
    return value;
}

struct Count {
    const char* key;
    std::uint64_t MeshInfo::*member;
};
constexpr std::array mesh_counts{Count{"vertices", &MeshInfo::vertices},
                                 Count{"edges", &MeshInfo::edges},
                                 Count{"faces", &MeshInfo::faces},
                                 Count{"half_edges", &MeshInfo::half_edges},
                                 Count{"boundary_faces", &MeshInfo::boundary_faces},
                                 Count{"components", &MeshInfo::components},
                                 Count{"cells", &MeshInfo::cells}};

JsonReader ciel_member(const JsonReader& document, const std::filesystem::path& file) {
    if (!document.is_object() || !document.find("ciel"))
        refuse(file, "has no 'ciel' attributes: the directory is a Zarr group, but not a CIEL dataset; "
                     "make a dataset with 'ciel import'");
    return document.at("ciel");
}

LateSource parse_late(const JsonReader& value) {
    LateSource late;
    for (const JsonReader& input : value.at("inputs").items()) late.inputs.push_back(input.text());
    for (const auto& [name, values] : value.at("options").members())
        for (const JsonReader& one : values.items()) late.options[name].push_back(one.text());
    late.changed = static_cast<std::int64_t>(value.at("changed").count());
    if (const auto files = value.find("files"))
        for (const JsonReader& of_step : files->items()) late.files.push_back(of_step.text());
    late.mesh = text_or_empty(value, "mesh");
    return late;
}

} // namespace

std::string to_text(Association association) {
    return std::ranges::find(association_names, association, &AssociationName::association)->name;
}

std::string to_text(Origin origin) { return std::ranges::find(origin_names, origin, &OriginName::origin)->name; }

DatasetInfo parse_root_attributes(std::string_view text, const std::filesystem::path& file) {
    const nlohmann::json json = parse_json(text, file);
    const JsonReader ciel = ciel_member(JsonReader(json, file), file);
    DatasetInfo info;
    const std::uint64_t version = ciel.at("format_version").count();
    if (version > layout::format_version)
        refuse(file, "was written by a newer CIEL (format " + std::to_string(version) +
                         ", but the installed CIEL reads format " + std::to_string(layout::format_version) +
                         "); update CIEL");
    if (version == 0) ciel.at("format_version").refuse_damage("must not be 0");
    info.format_version = static_cast<int>(version);
    info.id = ciel.at("id").text();
    info.source = text_or_empty(ciel, "source");
    info.created = text_or_empty(ciel, "created");
    info.length_units = text_or_empty(ciel, "length_units");
    const JsonReader input = ciel.at("input");
    info.input_vertices = input.at("vertices").count();
    info.input_edges = input.at("edges").count();
    info.input_cells = input.at("cells").count();
    if (const auto notes = ciel.find("notes"))
        for (const JsonReader& note : notes->items()) info.notes.push_back(note.text());
    if (const auto late = ciel.find("late")) info.late = parse_late(*late);
    return info;
}

std::string root_attributes_text(const DatasetInfo& info) {
    nlohmann::json ciel{
        {"format_version", info.format_version},
        {"id", info.id},
        {"source", info.source},
        {"created", info.created},
        {"length_units", info.length_units},
        {"input", {{"vertices", info.input_vertices}, {"edges", info.input_edges}, {"cells", info.input_cells}}},
        {"notes", info.notes}};
    if (!info.late.inputs.empty())
        ciel["late"] = {{"inputs", info.late.inputs},
                        {"options", info.late.options},
                        {"changed", info.late.changed},
                        {"files", info.late.files},
                        {"mesh", info.late.mesh}};
    return to_text(nlohmann::json{{"ciel", std::move(ciel)}});
}

MeshAttributes parse_mesh_attributes(std::string_view text, const std::filesystem::path& file) {
    const nlohmann::json json = parse_json(text, file);
    const JsonReader ciel = ciel_member(JsonReader(json, file), file);
    MeshAttributes mesh;
    mesh.origin = parse_numbers<3>(ciel.at("origin"));
    mesh.info.bounds = parse_numbers<6>(ciel.at("bounds"));
    const JsonReader counts = ciel.at("counts");
    for (const Count& count : mesh_counts) mesh.info.*count.member = counts.at(count.key).count();
    for (const auto& [type, count] : ciel.at("cells").members()) mesh.info.cells_by_type[type] = count.count();
    if (const auto groups = ciel.find("groups"))
        for (const JsonReader& group : groups->items()) mesh.groups.push_back(parse_group(group));
    for (const auto& [name, sum] : ciel.at("checksums").members()) mesh.checksums[name] = parse_checksum(sum);
    for (const JsonReader& sum : ciel.at("coordinate_checksums").items())
        mesh.coordinate_checksums.push_back(parse_checksum(sum));
    return mesh;
}

std::string to_text(const MeshAttributes& mesh) {
    nlohmann::json counts, groups = nlohmann::json::array();
    for (const Count& count : mesh_counts) counts[count.key] = mesh.info.*count.member;
    for (const GroupName& group : mesh.groups) groups.push_back(to_json(group));
    return to_text(nlohmann::json{{"ciel",
                                   {{"origin", mesh.origin},
                                    {"bounds", mesh.info.bounds},
                                    {"counts", counts},
                                    {"cells", mesh.info.cells_by_type},
                                    {"groups", groups},
                                    {"checksums", mesh.checksums},
                                    {"coordinate_checksums", mesh.coordinate_checksums}}}});
}

ArrayInfo parse_array_attributes(std::string_view text, const std::filesystem::path& file) {
    const nlohmann::json json = parse_json(text, file);
    const JsonReader ciel = ciel_member(JsonReader(json, file), file);
    ArrayInfo array;
    array.name = ciel.at("name").text();
    array.association = parse_association(ciel.at("association"));
    const std::uint64_t components = ciel.at("components").count();
    if (components == 0 || components > most_components)
        ciel.at("components").refuse_damage("must be 1 to " + std::to_string(most_components));
    array.components = static_cast<int>(components);
    array.units = text_or_empty(ciel, "units");
    array.description = text_or_empty(ciel, "description");
    if (const auto names = ciel.find("component_names"))
        array.component_names = parse_component_names(*names, components);
    const auto origin = ciel.find("origin");
    array.source.origin = origin ? parse_origin(*origin) : Origin::unknown;
    array.source.type = text_or_empty(ciel, "type");
    array.source.file = text_or_empty(ciel, "file");
    return array;
}

std::string to_text(const ArrayInfo& array) {
    nlohmann::json value{
        {"name", array.name},   {"association", to_text(array.association)}, {"components", array.components},
        {"units", array.units}, {"description", array.description},          {"origin", to_text(array.source.origin)}};
    if (!array.component_names.empty()) value["component_names"] = array.component_names;
    if (!array.source.type.empty()) value["type"] = array.source.type;
    if (!array.source.file.empty()) value["file"] = array.source.file;
    return to_text(nlohmann::json{{"ciel", std::move(value)}});
}

std::string group_attributes_text(const GroupName& group) { return to_text(nlohmann::json{{"ciel", to_json(group)}}); }

} // namespace server::store
