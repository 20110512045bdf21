#include "store/writer.hpp"

#include "store/cache/mapped_file.hpp"
#include "store/cache/stored_blocks.hpp"
#include "store/cell_places.hpp"
#include "store/commit.hpp"
#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/format/json_reader.hpp"
#include "store/format/layout.hpp"
#include "store/format/marker.hpp"
#include "store/format/value_ranges.hpp"
#include "store/imported_copy.hpp"
#include "store/mesh_arrays.hpp"
#include "store/mesh_counts.hpp"
#include "store/new_dataset_directory.hpp"
#include "store/new_dataset_info.hpp"
#include "store/statistics.hpp"
#include "store/valid_text.hpp"
#include "store/write_mesh.hpp"
#include "store/written_points.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace server::store {

namespace fs = std::filesystem;

namespace {

struct WrittenMesh {
    MeshAttributes attributes;
    std::map<std::string, ArrayInfo> arrays;
    std::uint64_t steps = 0;

    [[nodiscard]] std::uint64_t items(const ArrayInfo& array) const {
        return items_of(attributes.info, array.association);
    }
};

struct StepUnderWay {
    MarkedStep step;
    std::vector<ArrayInfo> arrays;
    std::vector<fs::path> chunks;
};

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

// Coordinate sets that were written with plain Zarr have no checksums.
void complete_checksums(MeshAttributes& attributes, const Dataset& dataset, std::size_t mesh) {
    const auto document = layout::mesh(dataset.directory(), mesh) / "positions" / layout::array_document;
    auto& sums = attributes.coordinate_checksums;
    for (const auto sets = parse_zarr_array(read_text(document, layout::document_bytes), document).shape[0];
         sums.size() < sets;)
        sums.push_back(checksum(dataset.mesh_arrays().points(mesh, sums.size()).positions.bytes()));
}

} // namespace

struct Writer::State {
    fs::path directory; // temporary directory of a new dataset, or the dataset when appending
    std::unique_ptr<NewDatasetDirectory> new_directory; // null when appending
    Descriptor lock;                                    // when appending: lock on the dataset's directory
    std::shared_ptr<Dataset> before;
    DatasetInfo info;
    Marker marker;
    std::optional<double> last_time; // time of the last step; nullopt if there is none
    std::vector<WrittenMesh> meshes;
    struct UsedMesh {
        std::size_t mesh;
        std::shared_ptr<const StoredBlocks> blocks; // null in format 1
        ciel::Topology topology;
    };
    std::optional<UsedMesh> used; // the mesh whose topology was used last; only one, because it keeps files open
    std::unique_ptr<StepUnderWay> under_way;
    bool info_changed = false, finished = false;

    State() = default;
    ~State() { take_back(); }
    State(const State&) = delete;

    [[nodiscard]] bool appending() const { return new_directory == nullptr; }

    [[nodiscard]] WrittenMesh& mesh(std::size_t index) {
        if (index >= meshes.size()) throw ciel::Error("the dataset has no mesh " + std::to_string(index));
        return meshes[index];
    }

    // When appending, replaces the file, because a reader may have mapped it. In a new dataset, writes it directly.
    void put(const fs::path& file, std::span<const std::byte> bytes) const {
        appending() ? replace_file(file, bytes) : write_file(file, bytes);
    }

    // Skips a file that has this content already, because replacing it would flush it to the disk.
    void put_text(const fs::path& file, const std::string& text) const {
        std::error_code error;
        if (appending() && fs::exists(file, error) && read_text(file, layout::marker_bytes) == text) return;
        put(file, bytes_of(text));
    }

    void put_array(const ArrayInfo& array, const WrittenMesh& on, const fs::path& path, std::uint64_t steps) const {
        put_text(path / layout::attributes_document, to_text(array));
        put_text(path / layout::array_document, to_text(values_shape(steps, on.items(array), array)));
    }

    void put_mesh(std::size_t index) const {
        const WrittenMesh& written = meshes[index];
        const fs::path path = layout::mesh(directory, index);
        put_text(path / layout::attributes_document, to_text(written.attributes));
        put_text(path / "positions" / layout::array_document,
                 to_text(positions_shape(written.attributes.coordinate_checksums.size(), written.attributes.info)));
        for (const auto& [name, array] : written.arrays)
            put_array(array, written, layout::values(path, name), written.steps);
    }

    void put_root() const {
        put_text(directory / layout::attributes_document, root_attributes_text(info));
        put_text(directory / layout::group_document, group_text());
        put_text(directory / "meshes" / layout::group_document, group_text());
    }

    [[nodiscard]] Commit commit() const { return {directory, info.id, appending()}; }

    void check_array(const ArrayValues& array, const WrittenMesh& on) const {
        const std::uint64_t items = on.items(array.info);
        if (array.info.components < 1 || array.info.components > 64)
            throw ciel::Error("array '" + array.info.name + "' must have 1 to 64 components");
        if (array.values.size() != items * static_cast<std::uint64_t>(array.info.components))
            throw ciel::Error("array '" + array.info.name + "' has " + std::to_string(array.values.size()) +
                              " values, but must have " + std::to_string(items) + " x " +
                              std::to_string(array.info.components) + ", one for each item and component");
        if (const ArrayInfo* known = find(array.info.name); known != nullptr && !known->has_shape_of(array.info))
            throw ciel::Error(
                "array '" + array.info.name +
                "' has another association or number of components than at earlier steps; use a new name");
    }

    [[nodiscard]] const ArrayInfo* find(const std::string& array) const {
        for (const WrittenMesh& mesh : meshes)
            if (const auto known = mesh.arrays.find(array); known != mesh.arrays.end()) return &known->second;
        return nullptr;
    }

    [[nodiscard]] ArrayInfo with_type(const ArrayInfo& array, ciel::ValuesView values) const {
        ArrayInfo typed = with_valid_text(array);
        const ArrayInfo* known = find(typed.name);
        typed.doubles = known != nullptr ? known->doubles : values.has_doubles();
        return typed;
    }

    // REQUIRES: the values have the array's type.
    void put_values(const ArrayInfo& array, ciel::ValuesView values) {
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

    void put_ranges(const ArrayInfo& array, ciel::ValuesView values, const fs::path& path, std::uint64_t row) {
        if (!has_blocks(under_way->step.mesh)) return;
        const ciel::Topology& topology = topology_of(under_way->step.mesh);
        const fs::path file = layout::value_ranges(path, row);
        make_directory(file.parent_path());
        under_way->chunks.push_back(file);
        put(file, to_bytes(value_ranges(values, array, topology), info.id, checksum_number(values.bytes())));
    }

    [[nodiscard]] bool has_blocks(std::size_t mesh) const {
        std::error_code error;
        return fs::exists(layout::block_index(layout::mesh(directory, mesh)).parent_path(), error);
    }
    [[nodiscard]] const ciel::Topology& topology_of(std::size_t mesh) {
        if (used && used->mesh == mesh) return used->topology;
        check_used();
        used.reset();
        std::shared_ptr<const StoredBlocks> blocks;
        if (has_blocks(mesh)) blocks = std::make_shared<const StoredBlocks>(layout::mesh(directory, mesh), info.id);
        ciel::Topology topology = blocks ? blocks->topology() : before->topology(mesh);
        return used.emplace(UsedMesh{mesh, std::move(blocks), std::move(topology)}).topology;
    }
    // Throws Error if records that were used have changed or could not be read again.
    void check_used() const {
        if (used && used->blocks) used->blocks->check_intact();
    }

    std::size_t add_mesh(const NewMesh& mesh, const OriginalIds& original, std::span<const NamedGroup> groups,
                         const SolverIds& solver) {
        const std::size_t index = meshes.size();
        const fs::path path = layout::mesh(directory, index);
        fs::remove_all(path); // may remain from an append that was not committed
        used.reset();
        meshes.push_back({write_mesh(path, mesh, original, with_valid_text(groups), solver, info.id), {}, 0});
        info_changed |= info.format_version != layout::format_version;
        info.format_version = layout::format_version;
        return index;
    }

    void put_documents() const {
        for (std::size_t m = 0; m < meshes.size(); ++m) put_mesh(m);
        if (info_changed) put_root();
    }

    void place_extremes(MarkedStep& step) {
        std::vector<ciel::Index> cells;
        for_extremes(step, [&](CellExtreme& extreme) { cells.push_back(extreme.cell); });
        if (cells.empty()) return;
        const WrittenPoints points(layout::mesh(directory, step.mesh), mesh(step.mesh).attributes, step.coordinates);
        const auto places = cell_places(topology_of(step.mesh), points.view(), cells);
        for_extremes(step, [&](CellExtreme& extreme) { extreme.place = places.at(extreme.cell); });
    }

    void learn_arrays(const StepUnderWay& of) {
        WrittenMesh& written = mesh(of.step.mesh);
        for (const ArrayInfo& array : of.arrays) written.arrays.emplace(array.name, array);
        ++written.steps;
    }

    // Deletes the chunks of the step that is being written, which no reader has seen.
    void take_back() noexcept {
        std::error_code ignored;
        if (under_way)
            for (const fs::path& chunk : under_way->chunks) fs::remove(chunk, ignored);
        under_way.reset();
    }
};

namespace {

// An error names files by their final paths, because the temporary directory will be deleted.
void read_again(const NewDatasetDirectory& directory) {
    try {
        const auto dataset = Dataset::open(directory.temporary());
        for (std::size_t mesh = 0; mesh < dataset->info().meshes.size(); ++mesh) {
            (void)dataset->mesh_arrays().points(mesh, 0);
            (void)dataset->mesh_arrays().numbered_faces(mesh, 0);
            (void)dataset->groups(mesh);
        }
    } catch (const ciel::Error& error) {
        std::string what = error.what();
        const std::string folder = directory.temporary().string();
        for (std::size_t at = 0; (at = what.find(folder, at)) != std::string::npos;)
            what.replace(at, folder.size(), directory.target().string());
        throw ciel::Error("the written dataset cannot be read back and was removed: " + what);
    }
}

} // namespace

Writer::Writer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Writer::Writer(Writer&&) noexcept = default;
Writer::~Writer() = default;

Writer::Writer(const fs::path& directory, const DatasetHeader& header, bool overwrite)
    : state_(std::make_unique<State>()) {
    state_->new_directory = std::make_unique<NewDatasetDirectory>(directory, overwrite);
    state_->directory = state_->new_directory->temporary();
    state_->info = new_dataset_info(header);
}

Writer Writer::append(const fs::path& directory) { return append(Dataset::open(directory, LackingRanges::left_out)); }

Writer Writer::append(std::shared_ptr<Dataset> dataset) {
    auto state = std::make_unique<State>();
    const fs::path& directory = state->directory = dataset->directory();
    if (const std::string input = input_of_copy(directory); !input.empty())
        refuse(directory, "is a copy that `ciel serve` made of " + input +
                              " and makes again when the source file changes, so appended steps would be lost; make a "
                              "dataset with `ciel import` and append to that dataset");
    if (!lock_directory(directory, state->lock))
        refuse(directory, "is being appended to by another process; wait until the process ends");
    if (auto now = dataset->refreshed()) dataset = std::move(now);
    remove_left_beside(directory);
    const auto attributes = directory / layout::attributes_document, marker = directory / layout::commit_marker;
    state->info = parse_root_attributes(read_text(attributes, layout::document_bytes), attributes);
    state->marker = parse_marker(read_text(marker, layout::marker_bytes), marker);
    for (std::size_t m = 0; m < state->marker.meshes; ++m) {
        const auto file = layout::mesh(directory, m) / layout::attributes_document;
        state->meshes.push_back({parse_mesh_attributes(read_text(file, layout::document_bytes), file), {}, 0});
        state->meshes.back().attributes.info.double_positions = dataset->info().meshes[m].double_positions;
        complete_checksums(state->meshes.back().attributes, *dataset, m);
    }
    const TableFacts& table = state->marker.table;
    for (std::size_t m = 0; m < table.chunks.size(); ++m) state->meshes[m].steps = table.chunks[m];
    for (const TableArray& array : table.arrays)
        for (const std::uint64_t m : array.meshes)
            state->meshes[m].arrays.emplace(array.name, *dataset->find(array.name));
    if (!dataset->steps().empty()) state->last_time = dataset->steps().times().back();
    for (const MarkedStep& step : state->marker.steps) {
        WrittenMesh& mesh = state->meshes[step.mesh];
        for (const auto& [name, array] : step.arrays) {
            mesh.arrays.emplace(name, *dataset->find(name));
            mesh.steps = std::max(mesh.steps, array.chunk + 1);
        }
    }
    state->before = std::move(dataset);
    return Writer(std::move(state));
}

const std::shared_ptr<Dataset>& Writer::before() const { return state_->before; }

std::size_t Writer::add_mesh(const ciel::FaceMesh& mesh, std::span<const ciel::Index> original_vertex,
                             std::span<const ciel::Index> original_cell, std::span<const NamedGroup> groups,
                             const SolverIds& solver) {
    return state_->add_mesh({mesh, nullptr}, {original_vertex, original_cell}, groups, solver);
}

std::size_t Writer::add_mesh(const ciel::MatchedCells& cells, const ciel::FaceMesh& boundary,
                             std::span<const ciel::Index> original_vertex, std::span<const ciel::Index> original_cell,
                             std::span<const NamedGroup> groups, const SolverIds& solver) {
    return state_->add_mesh({boundary, &cells}, {original_vertex, original_cell}, groups, solver);
}

const ciel::Topology& Writer::topology(std::size_t mesh) {
    (void)state_->mesh(mesh);
    return state_->topology_of(mesh);
}

Values Writer::positions(std::size_t mesh, std::size_t coordinates) const {
    const auto points = std::make_shared<const WrittenPoints>(layout::mesh(state_->directory, mesh),
                                                              state_->mesh(mesh).attributes, coordinates);
    return {points->view().positions, points};
}

bool Writer::holds(std::size_t mesh, ciel::ValuesView positions) const {
    return state_->mesh(mesh).attributes.info.double_positions || ciel::are_floats(positions);
}

std::size_t Writer::add_coordinates(std::size_t mesh, ciel::ValuesView positions) {
    MeshAttributes& attributes = state_->mesh(mesh).attributes;
    if (positions.size() != 3 * attributes.info.vertices)
        throw ciel::Error("new coordinates have " + std::to_string(positions.size() / 3) +
                          " points, but the number of vertices of the mesh is " +
                          std::to_string(attributes.info.vertices));
    if (!holds(mesh, positions))
        throw ciel::Error(
            "the new coordinates are float64 and the mesh stores float32; import all steps again together");
    check_finite(positions);
    const std::size_t index = attributes.coordinate_checksums.size();
    const Values stored = converted(positions, attributes.info.double_positions);
    state_->put(layout::chunk(layout::mesh(state_->directory, mesh) / "positions", index, 3), stored.bytes());
    attributes.coordinate_checksums.push_back(checksum(stored.bytes()));
    if (state_->has_blocks(mesh))
        write_boxes(layout::mesh(state_->directory, mesh), state_->topology_of(mesh), state_->info.id, index, stored);
    extend_bounds(attributes.info.bounds, attributes.origin, stored);
    return index;
}

std::optional<std::size_t> Writer::find_coordinates(std::size_t mesh, ciel::ValuesView positions) const {
    if (!holds(mesh, positions)) return std::nullopt;
    const MeshAttributes& attributes = state_->mesh(mesh).attributes;
    const Values stored = converted(positions, attributes.info.double_positions);
    const std::string sum = checksum(stored.bytes());
    const auto& sums = attributes.coordinate_checksums;
    for (std::size_t i = sums.size(); i-- > 0;) {
        if (sums[i] != sum) continue;
        const MappedFile file(layout::chunk(layout::mesh(state_->directory, mesh) / "positions", i, 3),
                              stored.size_bytes());
        if (std::ranges::equal(file.bytes(), stored.bytes())) return i;
    }
    return std::nullopt;
}

void Writer::add_step(double time, std::size_t mesh, std::size_t coordinates, std::span<const ArrayValues> arrays) {
    begin_step(time, mesh, coordinates);
    std::set<std::string> seen;
    for (const ArrayValues& array : arrays) { // checks all arrays before it writes the first array
        const ArrayValues named{with_valid_text(array.info), array.values};
        state_->check_array(named, state_->mesh(mesh));
        if (!seen.insert(named.info.name).second) throw ciel::Error("array '" + named.info.name + "' is given twice");
    }
    for (const ArrayValues& array : arrays) add_values(array);
    end_step();
}

void Writer::begin_step(double time, std::size_t mesh, std::size_t coordinates) {
    State& state = *state_;
    state.take_back();
    const WrittenMesh& written = state.mesh(mesh);
    if (!std::isfinite(time)) throw ciel::Error("the time of a step must be a finite number");
    if (state.last_time && !(time > *state.last_time))
        throw ciel::Error("time " + std::to_string(time) + " is not later than the last step, which is at time " +
                          std::to_string(*state.last_time));
    if (coordinates >= written.attributes.coordinate_checksums.size())
        throw ciel::Error("mesh " + std::to_string(mesh) + " has no coordinate set " + std::to_string(coordinates));
    state.under_way = std::make_unique<StepUnderWay>(StepUnderWay{{time, mesh, coordinates, {}}, {}, {}});
}

void Writer::add_values(const ArrayValues& array) {
    State& state = *state_;
    if (!state.under_way) throw ciel::Error("array '" + array.info.name + "' belongs to no step; begin a step first");
    try {
        const ArrayInfo info = state.with_type(array.info, array.values);
        const MarkedStep& step = state.under_way->step;
        state.check_array({info, array.values}, state.mesh(step.mesh));
        if (step.arrays.count(info.name) > 0) throw ciel::Error("array '" + info.name + "' is given twice");
        state.put_values(info, converted(array.values, info.doubles));
    } catch (...) {
        state.take_back();
        throw;
    }
}

void Writer::end_step() {
    State& state = *state_;
    if (!state.under_way) throw ciel::Error("there is no step to end; begin a step first");
    try {
        state.place_extremes(state.under_way->step);
        state.check_used();
    } catch (...) {
        state.take_back();
        throw;
    }
    const double time = state.under_way->step.time;
    if (!state.appending()) {
        state.learn_arrays(*state.under_way);
        state.marker.steps.push_back(std::move(state.under_way->step));
        state.last_time = time;
        return state.under_way.reset();
    }
    const std::vector<WrittenMesh> meshes = state.meshes;
    const std::size_t known_meshes = state.marker.meshes;
    try {
        state.learn_arrays(*state.under_way);
        state.put_documents();
    } catch (...) {
        state.meshes = meshes;
        state.take_back();
        throw;
    }
    state.marker.meshes = state.meshes.size();
    state.marker.steps.push_back(state.under_way->step);
    state.under_way.reset(); // does not delete the chunks, because put may throw after it has replaced the marker
    try {
        state.commit().put(state.marker);
    } catch (...) {
        state.meshes = meshes;
        state.marker.meshes = known_meshes;
        state.marker.steps.pop_back();
        throw;
    }
    state.last_time = time;
    // The step is committed. Therefore errors are ignored. The next step tries again to move the steps.
    try {
        (void)state.commit().move_steps_to_table(state.marker);
    } catch (const std::exception&) {
        state.commit().read_table_again(state.marker);
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
        if (state.meshes.empty()) throw ciel::Error("the dataset has no mesh; nothing was written");
        make_directory(state.directory / "meshes");
        state.marker.meshes = state.meshes.size();
        for (std::size_t m = 0; m < state.meshes.size(); ++m) state.put_mesh(m);
        state.put_root();
        if (!state.commit().move_steps_to_table(state.marker)) state.commit().put(state.marker);
        state.used.reset();
        read_again(*state.new_directory);
        state.new_directory->commit();
    }
    state.finished = true;
}

} // namespace server::store
