#include "store/writer.hpp"

#include "store/checksum.hpp"
#include "store/files.hpp"
#include "store/json_reader.hpp"
#include "store/layout.hpp"
#include "store/marker.hpp"
#include "store/mesh_counts.hpp"
#include "store/place.hpp"
#include "store/statistics.hpp"
#include "store/write_mesh.hpp"

#include <cmath>
#include <ctime>
#include <random>
#include <set>

namespace ciel::store {

namespace fs = std::filesystem;

namespace {

std::string now_iso8601() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text;
}

std::string random_id() {
    std::random_device device;
    std::uint32_t words[4];
    for (std::uint32_t& word : words) word = device();
    return checksum(std::as_bytes(std::span(words))).substr(5);
}

struct WrittenMesh {
    MeshAttributes attributes;
    std::map<std::string, ArrayInfo> arrays;
    std::uint64_t steps = 0;
};

} // namespace

struct Writer::State {
    fs::path directory;           // where the files go now
    std::unique_ptr<Place> place; // none when appending
    Descriptor lock;              // appending: one process at a time
    DatasetInfo info;
    Marker marker;
    std::vector<WrittenMesh> meshes;
    bool info_changed = false, finished = false;

    [[nodiscard]] bool appending() const { return place == nullptr; }

    [[nodiscard]] WrittenMesh& mesh(std::size_t index) {
        if (index >= meshes.size()) throw Error("there is no mesh " + std::to_string(index) + " to add to");
        return meshes[index];
    }

    // A file that a reader may have mapped is replaced, one that nobody can see yet is written.
    void put(const fs::path& file, std::span<const std::byte> bytes) const {
        appending() ? replace_file(file, bytes) : write_file(file, bytes);
    }

    // Nothing is flushed again that an append leaves as it was.
    void put_text(const fs::path& file, const std::string& text) const {
        if (appending() && fs::exists(file) && read_text(file, layout::marker_bytes) == text) return;
        put(file, bytes_of(text));
    }

    void put_array(const ArrayInfo& array, const WrittenMesh& on, const fs::path& path, std::uint64_t steps) const {
        const std::uint64_t items =
            array.association == Association::point ? on.attributes.info.vertices : on.attributes.info.cells;
        put_text(path / layout::attributes_document, to_text(array));
        put_text(path / layout::array_document, to_text(values_shape(steps, items, array.components)));
    }

    void put_mesh(std::size_t index) const {
        const WrittenMesh& written = meshes[index];
        const fs::path path = layout::mesh(directory, index);
        put_text(path / layout::attributes_document, to_text(written.attributes));
        put_text(
            path / "positions" / layout::array_document,
            to_text(positions_shape(written.attributes.coordinate_checksums.size(), written.attributes.info.vertices)));
        for (const auto& [name, array] : written.arrays)
            put_array(array, written, layout::values(path, name), written.steps);
    }

    void put_root() const {
        put_text(directory / layout::attributes_document, root_attributes_text(info));
        put_text(directory / layout::group_document, group_text());
        put_text(directory / "meshes" / layout::group_document, group_text());
    }

    void put_marker() const { put_text(directory / layout::commit_marker, to_text(marker)); }

    void check_array(const ArrayValues& array, const WrittenMesh& on) const {
        const std::uint64_t items =
            array.info.association == Association::point ? on.attributes.info.vertices : on.attributes.info.cells;
        if (array.info.components < 1 || array.info.components > 64)
            throw Error("array '" + array.info.name + "' must have 1 to 64 components");
        if (array.values.size() != items * static_cast<std::uint64_t>(array.info.components))
            throw Error("array '" + array.info.name + "' has " + std::to_string(array.values.size()) +
                        " values where " + std::to_string(items) + " x " + std::to_string(array.info.components) +
                        " are needed");
        for (const WrittenMesh& mesh : meshes)
            if (const auto known = mesh.arrays.find(array.info.name);
                known != mesh.arrays.end() && (known->second.association != array.info.association ||
                                               known->second.components != array.info.components))
                throw Error("array '" + array.info.name +
                            "' has another association or number of components than before");
    }

    MarkedArray put_values(const ArrayValues& array, std::size_t mesh, std::uint64_t row) const {
        const fs::path path = layout::values(layout::mesh(directory, mesh), array.info.name);
        make_directory(path);
        const auto bytes = std::as_bytes(array.values);
        put(layout::chunk(path, row, array.info.components > 1 ? 3 : 2), bytes);
        return {row, checksum(bytes), statistics(array.values, array.info.components), false};
    }
};

Writer::Writer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Writer::Writer(Writer&&) noexcept = default;
Writer::~Writer() = default;

Writer::Writer(const fs::path& directory, const DatasetHeader& header, bool overwrite)
    : state_(std::make_unique<State>()) {
    state_->place = std::make_unique<Place>(directory, overwrite);
    state_->directory = state_->place->temporary();
    DatasetInfo& info = state_->info;
    info.id = random_id();
    info.created = now_iso8601();
    info.source = valid_utf8(header.source);
    info.length_units = valid_utf8(header.length_units);
    info.input_vertices = header.input_vertices;
    info.input_edges = header.input_edges;
    info.input_cells = header.input_cells;
    for (const std::string& note : header.notes) info.notes.push_back(valid_utf8(note));
}

Writer Writer::append(const fs::path& directory) {
    auto state = std::make_unique<State>();
    state->directory = directory;
    if (fs::is_directory(directory) && !lock_directory(directory, state->lock))
        refuse(directory, "is being appended to by another process; wait for it to end");
    const auto dataset = Dataset::open(directory); // refuses what is damaged before anything is added
    const auto attributes = directory / layout::attributes_document, marker = directory / layout::commit_marker;
    state->info = parse_root_attributes(read_text(attributes, layout::document_bytes), attributes);
    state->marker = parse_marker(read_text(marker, layout::marker_bytes), marker);
    for (std::size_t m = 0; m < state->marker.meshes; ++m) {
        const auto file = layout::mesh(directory, m) / layout::attributes_document;
        state->meshes.push_back({parse_mesh_attributes(read_text(file, layout::document_bytes), file), {}, 0});
        // Coordinates that came by plain Zarr have no checksum yet.
        const auto positions = layout::mesh(directory, m) / "positions" / layout::array_document;
        auto& sums = state->meshes.back().attributes.coordinate_checksums;
        for (const auto sets = parse_zarr_array(read_text(positions, layout::document_bytes), positions).shape[0];
             sums.size() < sets;)
            sums.push_back(checksum(std::as_bytes(dataset->mesh(m, sums.size()).positions)));
    }
    for (const MarkedStep& step : state->marker.steps) {
        WrittenMesh& mesh = state->meshes[step.mesh];
        for (const auto& [name, array] : step.arrays) {
            mesh.arrays.emplace(name, *dataset->find(name));
            mesh.steps = std::max(mesh.steps, array.chunk + 1);
        }
    }
    return Writer(std::move(state));
}

std::size_t Writer::add_mesh(const FaceMesh& mesh, std::span<const Index> original_vertex,
                             std::span<const Index> original_cell, std::span<const NamedGroup> groups) {
    const std::size_t index = state_->meshes.size();
    const fs::path path = layout::mesh(state_->directory, index);
    fs::remove_all(path); // left by an append that did not reach its commit
    std::vector<NamedGroup> named(groups.begin(), groups.end());
    for (NamedGroup& group : named) group.name = valid_utf8(group.name);
    state_->meshes.push_back({write_mesh(path, mesh, original_vertex, original_cell, named), {}, 0});
    return index;
}

std::size_t Writer::add_coordinates(std::size_t mesh, std::span<const float> positions) {
    WrittenMesh& written = state_->mesh(mesh);
    MeshAttributes& attributes = written.attributes;
    if (positions.size() != 3 * attributes.info.vertices)
        throw Error("new coordinates have " + std::to_string(positions.size() / 3) + " points where the mesh has " +
                    std::to_string(attributes.info.vertices));
    check_finite(positions);
    const std::size_t index = attributes.coordinate_checksums.size();
    const auto bytes = std::as_bytes(positions);
    state_->put(layout::chunk(layout::mesh(state_->directory, mesh) / "positions", index, 3), bytes);
    attributes.coordinate_checksums.push_back(checksum(bytes));
    extend_bounds(attributes.info.bounds, attributes.origin, positions);
    return index;
}

void Writer::add_step(double time, std::size_t mesh, std::size_t coordinates, std::span<const ArrayValues> arrays) {
    State& state = *state_;
    WrittenMesh& written = state.mesh(mesh);
    if (!std::isfinite(time)) throw Error("a time step must have a finite time");
    if (!state.marker.steps.empty() && !(time > state.marker.steps.back().time))
        throw Error("time " + std::to_string(time) + " is not later than the last step, " +
                    std::to_string(state.marker.steps.back().time));
    if (coordinates >= written.attributes.coordinate_checksums.size())
        throw Error("mesh " + std::to_string(mesh) + " has no coordinates " + std::to_string(coordinates));

    std::vector<ArrayValues> named(arrays.begin(), arrays.end());
    std::set<std::string> seen;
    for (ArrayValues& array : named) {
        array.info = {valid_utf8(array.info.name), array.info.association, array.info.components,
                      valid_utf8(array.info.units), valid_utf8(array.info.description)};
        state.check_array(array, written);
        if (!seen.insert(array.info.name).second) throw Error("array '" + array.info.name + "' is given twice");
    }
    MarkedStep step{time, mesh, coordinates, {}};
    for (const ArrayValues& array : named)
        step.arrays.emplace(array.info.name, state.put_values(array, mesh, written.steps));

    for (const ArrayValues& array : named) written.arrays.emplace(array.info.name, array.info);
    ++written.steps;
    state.marker.meshes = state.meshes.size();
    state.marker.steps.push_back(std::move(step));
    if (!state.appending()) return;
    try {
        for (std::size_t m = 0; m < state.meshes.size(); ++m) state.put_mesh(m);
        if (state.info_changed) state.put_root();
        state.put_marker();
    } catch (...) {
        state.marker.steps.pop_back();
        --written.steps;
        throw;
    }
}

void Writer::add_note(const std::string& sentence) {
    state_->info.notes.push_back(valid_utf8(sentence));
    state_->info_changed = true;
}

void Writer::finish() {
    State& state = *state_;
    if (state.finished) return;
    if (state.appending()) {
        if (state.info_changed) state.put_root();
    } else {
        if (state.meshes.empty()) throw Error("the dataset has no mesh; nothing was written");
        make_directory(state.directory / "meshes");
        state.marker.meshes = state.meshes.size();
        for (std::size_t m = 0; m < state.meshes.size(); ++m) state.put_mesh(m);
        state.put_root();
        state.put_marker();
        (void)Dataset::open(state.directory);
        state.place->commit();
    }
    state.finished = true;
}

} // namespace ciel::store
