#include "geometry/default_scene.hpp"
#include "methods/cell_extremes.hpp"

namespace server::methods {
namespace {

protocol::MeshInfo mesh_of(const store::MeshInfo& mesh) {
    protocol::MeshInfo info;
    const auto whole = [](std::uint64_t count) { return static_cast<std::int64_t>(count); };
    info.vertices = whole(mesh.vertices);
    info.edges = whole(mesh.edges);
    info.faces = whole(mesh.faces);
    info.half_edges = whole(mesh.half_edges);
    info.boundary_faces = whole(mesh.boundary_faces);
    info.components = whole(mesh.components);
    for (const auto& [type, count] : mesh.cells_by_type) info.cells[type] = whole(count);
    return info;
}

// The range and the counts cover all written steps except late steps, which have not been read from the source yet.
protocol::ArrayInfo array_of(const store::Dataset& dataset, const store::ArrayInfo& array) {
    protocol::ArrayInfo info;
    info.name = array.name;
    info.association = store::to_text(array.association);
    info.components = array.components;
    info.units = array.units;
    info.description = array.description;
    info.scalars = store::scalar_names(array);
    info.origin = store::to_text(array.source.origin);
    if (!array.source.type.empty()) info.type = array.source.type;
    info.stored = array.doubles ? "float64" : "float32";
    if (!array.source.file.empty()) info.file = array.source.file;
    info.extremes = answer_of(store::range_extremes(dataset, array));
    for (const store::Step& step : dataset.steps()) {
        const auto written = step.arrays.find(array.name);
        if (written == step.arrays.end()) continue;
        info.times.push_back(step.time);
        info.invalid += static_cast<std::int64_t>(written->second.invalid);
        info.missing += static_cast<std::int64_t>(written->second.missing);
        const auto& range = written->second.range;
        if (written->second.late) continue;
        if (!info.range) info.range = range;
        info.range = {std::min((*info.range)[0], range[0]), std::max((*info.range)[1], range[1])};
    }
    return info;
}

std::int64_t unread_steps(const store::Dataset& dataset) {
    return std::ranges::count_if(dataset.steps(), [](const store::Step& step) {
        return std::ranges::any_of(step.arrays, [](const auto& array) { return array.second.late; });
    });
}

std::vector<protocol::DatasetDescriptionGroupsItem> groups_of(const store::Dataset& dataset, std::size_t mesh) {
    std::vector<protocol::DatasetDescriptionGroupsItem> groups;
    for (const store::Group& group : dataset.groups(mesh)) {
        protocol::DatasetDescriptionGroupsItem& item = groups.emplace_back();
        item.name = group.name;
        item.of = group.of == store::Group::Of::faces ? "faces" : "cells";
        item.count = static_cast<std::int64_t>(group.ids.size());
        if (!group.facts.type.empty()) item.type = group.facts.type;
        if (!group.facts.conditions.empty()) item.conditions = group.facts.conditions;
    }
    return groups;
}

} // namespace

protocol::DatasetDescribeResult dataset_describe(CallContext& context, const protocol::DatasetDescribeParams& params) {
    const auto loaded = context.dataset(params.dataset);
    const auto dataset = loaded->dataset();
    const store::DatasetInfo& info = dataset->info();
    protocol::DatasetDescription description;
    description.name = params.dataset;
    description.source = info.source;
    description.created = info.created;
    description.length_units = info.length_units;
    description.times.assign(dataset->steps().times().begin(), dataset->steps().times().end());
    if (const std::int64_t unread = unread_steps(*dataset); unread > 0) description.unread_steps = unread;
    description.input = {static_cast<std::int64_t>(info.input_vertices), static_cast<std::int64_t>(info.input_edges),
                         static_cast<std::int64_t>(info.input_cells)};
    const std::size_t mesh = dataset->steps().empty() ? 0 : dataset->steps().front().mesh;
    if (mesh < info.meshes.size()) {
        description.bounds = info.meshes[mesh].bounds;
        description.mesh = mesh_of(info.meshes[mesh]);
        description.groups = groups_of(*dataset, mesh);
    }
    for (const store::ArrayInfo& array : info.arrays) description.arrays.push_back(array_of(*dataset, array));
    description.notes = info.notes;
    geometry::DefaultScene shown = geometry::default_scene(*loaded, params.dataset);
    description.default_scene = std::move(shown.document);
    const auto& [low, high] = shown.box;
    description.default_bounds = {low[0], high[0], low[1], high[1], low[2], high[2]};
    return description;
}

} // namespace server::methods
