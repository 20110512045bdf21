#include "store/writer_state.hpp"

#include "store/cell_places.hpp"
#include "store/format/checksum.hpp"
#include "store/format/value_ranges.hpp"
#include "store/statistics.hpp"
#include "store/valid_text.hpp"
#include "store/written_points.hpp"

namespace server::store {

namespace fs = std::filesystem;

namespace {

template <class F>
void for_extremes(MarkedStep& step, F&& f) {
    for (auto& [name, array] : step.arrays) {
        if (!array.statistics) continue;
        for (CellExtremes& extremes : array.statistics->extremes) {
            f(extremes.lowest);
            f(extremes.highest);
        }
    }
}

} // namespace

WrittenMesh& Writer::State::mesh(std::size_t index) {
    if (index >= meshes.size()) throw ciel::Error("the dataset has no mesh " + std::to_string(index));
    return meshes[index];
}

void Writer::State::put_text(const fs::path& file, const std::string& text) const {
    std::error_code error;
    if (appending() && fs::exists(file, error) && read_text(file, layout::marker_bytes) == text) return;
    put(file, bytes_of(text));
}

void Writer::State::put_array(const ArrayInfo& array, const WrittenMesh& on, const fs::path& path,
                              std::uint64_t steps) const {
    put_text(path / layout::attributes_document, to_text(array));
    put_text(path / layout::array_document, to_text(values_shape(steps, on.items(array), array)));
}

void Writer::State::put_mesh(std::size_t index) const {
    const WrittenMesh& written = meshes[index];
    const fs::path path = layout::mesh(directory, index);
    put_text(path / layout::attributes_document, to_text(written.attributes));
    put_text(path / "positions" / layout::array_document,
             to_text(positions_shape(written.attributes.coordinate_checksums.size(), written.attributes.info)));
    for (const auto& [name, array] : written.arrays)
        put_array(array, written, layout::values(path, name), written.steps);
}

void Writer::State::put_root() const {
    put_text(directory / layout::attributes_document, root_attributes_text(info));
    put_text(directory / layout::group_document, group_text());
    put_text(directory / "meshes" / layout::group_document, group_text());
}

void Writer::State::check_array(const ArrayValues& array, const WrittenMesh& on) const {
    const std::uint64_t items = on.items(array.info);
    if (array.info.components < 1 || array.info.components > 64)
        throw ciel::Error("array '" + array.info.name + "' must have 1 to 64 components");
    if (array.values.size() != items * static_cast<std::uint64_t>(array.info.components))
        throw ciel::Error("array '" + array.info.name + "' has " + std::to_string(array.values.size()) +
                          " values, but must have " + std::to_string(items) + " x " +
                          std::to_string(array.info.components) + ", one for each item and component");
    if (const ArrayInfo* known = find(array.info.name); known != nullptr && !known->has_shape_of(array.info))
        throw ciel::Error("array '" + array.info.name +
                          "' has another association or number of components than at earlier steps; use a new name");
}

const ArrayInfo* Writer::State::find(const std::string& array) const {
    for (const WrittenMesh& mesh : meshes)
        if (const auto known = mesh.arrays.find(array); known != mesh.arrays.end()) return &known->second;
    return nullptr;
}

ArrayInfo Writer::State::with_type(const ArrayInfo& array, ciel::ValuesView values) const {
    ArrayInfo typed = with_valid_text(array);
    const ArrayInfo* known = find(typed.name);
    typed.doubles = known != nullptr ? known->doubles : values.has_doubles();
    return typed;
}

void Writer::State::put_values(const ArrayInfo& array, ciel::ValuesView values) {
    MarkedStep& step = under_way->step;
    const std::uint64_t row = mesh(step.mesh).steps;
    const fs::path path = layout::values(layout::mesh(directory, step.mesh), array.name);
    make_directory(path);
    under_way->chunks.push_back(layout::chunk(path, row, array.components > 1 ? 3 : 2));
    const auto bytes = values.bytes();
    put(under_way->chunks.back(), bytes);
    put_ranges(array, values, path, row);
    under_way->arrays.push_back(array);
    step.arrays.emplace(array.name, MarkedArray{row, checksum(bytes), statistics(values, array), false});
}

void Writer::State::put_ranges(const ArrayInfo& array, ciel::ValuesView values, const fs::path& path,
                               std::uint64_t row) {
    if (!has_blocks(under_way->step.mesh)) return;
    const ciel::Topology& topology = topology_of(under_way->step.mesh);
    const fs::path file = layout::value_ranges(path, row);
    make_directory(file.parent_path());
    under_way->chunks.push_back(file);
    put(file, to_bytes(value_ranges(values, array, topology), info.id, checksum_number(values.bytes())));
}

const ciel::Topology& Writer::State::topology_of(std::size_t mesh) {
    if (used && used->mesh == mesh) return used->topology;
    check_used();
    used.reset();
    std::shared_ptr<const StoredBlocks> blocks;
    if (has_blocks(mesh)) blocks = std::make_shared<const StoredBlocks>(layout::mesh(directory, mesh), info.id);
    ciel::Topology topology = blocks ? blocks->topology() : before->topology(mesh);
    return used.emplace(UsedMesh{mesh, std::move(blocks), std::move(topology)}).topology;
}

std::size_t Writer::State::add_mesh(const NewMesh& mesh, const OriginalIds& original,
                                    std::span<const NamedGroup> groups, const SolverIds& solver) {
    const std::size_t index = meshes.size();
    const fs::path path = layout::mesh(directory, index);
    fs::remove_all(path); // may remain from an append that was not committed
    used.reset();
    meshes.push_back({write_mesh(path, mesh, original, with_valid_text(groups), solver, info.id), {}, 0});
    info_changed |= info.format_version != layout::format_version;
    info.format_version = layout::format_version;
    return index;
}

void Writer::State::put_documents() const {
    for (std::size_t m = 0; m < meshes.size(); ++m) put_mesh(m);
    if (info_changed) put_root();
}

void Writer::State::place_extremes(MarkedStep& step) {
    std::vector<ciel::Index> cells;
    for_extremes(step, [&](CellExtreme& extreme) { cells.push_back(extreme.cell); });
    if (cells.empty()) return;
    const WrittenPoints points(layout::mesh(directory, step.mesh), mesh(step.mesh).attributes, step.coordinates);
    const auto places = cell_places(topology_of(step.mesh), points.view(), cells);
    for_extremes(step, [&](CellExtreme& extreme) { extreme.place = places.at(extreme.cell); });
}

void Writer::State::learn_arrays(const StepUnderWay& of) {
    WrittenMesh& written = mesh(of.step.mesh);
    for (const ArrayInfo& array : of.arrays) written.arrays.emplace(array.name, array);
    ++written.steps;
}

void Writer::State::take_back() noexcept {
    std::error_code ignored;
    if (under_way)
        for (const fs::path& chunk : under_way->chunks) fs::remove(chunk, ignored);
    under_way.reset();
}

} // namespace server::store
