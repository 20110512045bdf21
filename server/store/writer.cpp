#include "store/writer.hpp"

#include "store/cache/mapped_file.hpp"
#include "store/format/checksum.hpp"
#include "store/format/json_reader.hpp"
#include "store/format/zarr_array.hpp"
#include "store/imported_copy.hpp"
#include "store/mesh_arrays.hpp"
#include "store/mesh_counts.hpp"
#include "store/new_dataset_info.hpp"
#include "store/valid_text.hpp"
#include "store/writer_state.hpp"
#include "store/written_points.hpp"

#include <algorithm>

namespace server::store {

namespace fs = std::filesystem;

namespace {

// Coordinate sets that were written with plain Zarr have no checksums in the attributes, so these are computed here.
void complete_checksums(MeshAttributes& attributes, const Dataset& dataset, std::size_t mesh) {
    const auto document = layout::mesh(dataset.directory(), mesh) / "positions" / layout::array_document;
    auto& sums = attributes.coordinate_checksums;
    for (const auto sets = parse_zarr_array(read_text(document, layout::document_bytes), document).shape[0];
         sums.size() < sets;)
        sums.push_back(checksum(dataset.mesh_arrays().points(mesh, sums.size()).positions.bytes()));
}

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

void Writer::set_late(LateSource source) {
    state_->info.late = std::move(source);
    state_->info_changed = true;
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
