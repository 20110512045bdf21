#include "store/dataset.hpp"

#include "store/cache/chunk_cache.hpp"
#include "store/cache/loss_check.hpp"
#include "store/cache/mapped_mesh.hpp"
#include "store/cache/stored_array.hpp"
#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/format/documents.hpp"
#include "store/format/layout.hpp"
#include "store/format/step_table.hpp"
#include "store/late_files.hpp"
#include "store/mesh_arrays.hpp"
#include "store/statistics.hpp"

#include <algorithm>
#include <mutex>

namespace server::store {
namespace {

namespace fs = std::filesystem;

// -1 in the file means that the solver gave no id.
std::optional<std::int64_t> given(std::optional<std::int64_t> id) { return id && *id >= 0 ? id : std::nullopt; }

class MappedDataset final : public Dataset, private MeshArrays {
public:
    MappedDataset(fs::path directory, Documents documents, LackingRanges lacking, FileAccess access,
                  const fs::path& late_folder, const MappedDataset* before)
        : directory_(std::move(directory)), info_(std::move(documents.info)), marker_(std::move(documents.marker)),
          losses_(before != nullptr ? before->losses_ : no_losses()), late_folder_(late_folder),
          late_files_(directory_, late_folder, info_.id), late_changes_(late_files_.changes()), access_(access) {
        if (before != nullptr) {
            chunks_ = before->chunks_;
            meshes_ = before->meshes_;
        }
        for (std::size_t m = meshes_.size(); m < marker_.meshes; ++m)
            meshes_.push_back(std::make_shared<MappedMesh>(layout::mesh(directory_, m), info_.id, losses_, access_));
        for (std::size_t m = 0; m < meshes_.size(); ++m) {
            positions_.push_back(read_layout(meshes_[m]->directory() / "positions", meshes_[m]->vertex_count(), 3));
            coordinate_checksums_.push_back(coordinate_checksums(m, before));
            info_.meshes.push_back(meshes_[m]->attributes().info);
            info_.meshes[m].double_positions = positions_[m].doubles;
        }
        layouts_.resize(meshes_.size());
        table_ = std::make_unique<StepTable>(directory_, marker_.table, info_.id);
        learn_arrays_of_table();
        for (std::size_t i = 0; i < marker_.steps.size(); ++i) learn_arrays(table_->size() + i, marker_.steps[i]);
        steps_ = std::make_unique<Steps>(
            times(), [this, lacking](std::size_t step) { return read_step(step, lacking); },
            before != nullptr ? before->steps_.get() : nullptr);
        for (std::size_t step = table_->size(); step < steps_->size(); ++step) (void)(*steps_)[step];
    }

    const fs::path& directory() const override { return directory_; }
    const DatasetInfo& info() const override { return info_; }
    const Steps& steps() const override { return *steps_; }

    std::shared_ptr<Dataset> refreshed() const override {
        for (const auto& mesh : meshes_) mesh->check_unchanged();
        chunks_->check_sizes();
        Documents now = read_documents(directory_);
        const std::size_t steps = now.marker.table.steps + now.marker.steps.size();
        if (now.info.id != info_.id || steps < steps_->size() || now.marker.meshes < meshes_.size())
            refuse(directory_, "was replaced by another dataset while it was open; open the dataset again");
        const auto is_whole_now = [&](std::size_t step) { return late_chunks(step).empty(); };
        if (steps == steps_->size() && late_files_.changes() == late_changes_ &&
            std::ranges::none_of(steps_->known_with_late_arrays(), is_whole_now))
            return nullptr;
        return std::make_shared<MappedDataset>(directory_, std::move(now), LackingRanges::computed, access_,
                                               late_folder_, this);
    }

    void check_intact() const override {
        loss_check_([this] {
            for (const auto& mesh : meshes_) mesh->check_intact();
            chunks_->check_intact();
        });
    }

    void check_unchanged() const override {
        check_intact();
        for (const auto& mesh : meshes_) mesh->check_unchanged();
    }

    const MeshArrays& mesh_arrays() const override { return *this; }
    ciel::FaceMeshView all_faces(std::size_t mesh, std::size_t coordinates) const override {
        const ciel::FaceMeshView view = points(mesh, coordinates);
        return naming_changed_file([&] { return at(mesh)->all_faces(view); });
    }
    ciel::FaceMeshView points(std::size_t mesh, std::size_t coordinates) const override {
        const Values all = positions(mesh, coordinates);
        return of_dataset(at(mesh)->view_points(all), mesh, all.keep_alive());
    }
    ciel::FaceMeshView points_to_load(std::size_t mesh, std::size_t coordinates) const override {
        if (!at(mesh)->has_blocks()) return points(mesh, coordinates);
        const ValuesToLoad to_load = positions_to_load(mesh, coordinates);
        const auto loader = loader_of(to_load, mesh, coordinates);
        ciel::FaceMeshView view = of_dataset(at(mesh)->view_points(to_load.values), mesh, loader);
        view.loader = loader.get();
        return view;
    }
    ciel::FaceMeshView numbered_faces(std::size_t mesh, std::size_t coordinates) const override {
        ciel::FaceMeshView faces = at(mesh)->numbered_faces(points_to_load(mesh, coordinates));
        check_intact();
        return faces;
    }
    ciel::FaceMeshView boundary(std::size_t mesh, std::size_t coordinates) const override {
        ciel::FaceMeshView faces = at(mesh)->boundary(points_to_load(mesh, coordinates));
        check_intact();
        return faces;
    }
    void verify() const override {
        for (std::size_t m = 0; m < meshes_.size(); ++m) {
            for (std::size_t set = 0; set < positions_[m].chunks; ++set) {
                (void)positions(m, set);
                (void)block_boxes(m, set);
            }
            meshes_[m]->verify();
        }
        for (std::size_t step = 0; step < steps_->size(); ++step)
            for (const auto& [name, array] : (*steps_)[step].arrays)
                if (!array.late) {
                    (void)values(name, step);
                    (void)value_ranges(name, step);
                }
    }

    ciel::Topology topology(std::size_t mesh) const override {
        const MappedMesh& of = *at(mesh);
        return of.has_blocks() ? of.stored_topology() : ciel::Topology(all_faces(mesh, 0));
    }

    std::vector<Group> groups(std::size_t mesh) const override { return at(mesh)->groups(); }
    std::span<const ciel::Index> original_vertex(std::size_t mesh) const override {
        return at(mesh)->original_vertex();
    }
    std::span<const ciel::Index> original_cell(std::size_t mesh) const override { return at(mesh)->original_cell(); }

    std::span<const std::int64_t> solver_vertex(std::size_t mesh) const override { return at(mesh)->solver_vertex(); }
    std::span<const std::int64_t> solver_cell(std::size_t mesh) const override { return at(mesh)->solver_cell(); }
    ciel::Index original_vertex(std::size_t mesh, ciel::Index vertex) const override {
        return at(mesh)->original_vertex(vertex);
    }
    ciel::Index original_cell(std::size_t mesh, ciel::Index cell) const override {
        return at(mesh)->original_cell(cell);
    }
    std::optional<std::int64_t> solver_vertex(std::size_t mesh, ciel::Index vertex) const override {
        return given(at(mesh)->solver_vertex(vertex));
    }
    std::optional<std::int64_t> solver_cell(std::size_t mesh, ciel::Index cell) const override {
        return given(at(mesh)->solver_cell(cell));
    }

    std::optional<ciel::BlockRanges> block_ranges(const ScalarName& scalar, std::size_t step) const override {
        if (find(scalar.array)->association != Association::point) return std::nullopt;
        auto ranges = value_ranges(scalar.array, step);
        if (!ranges) return std::nullopt;
        return std::move(ranges->scalars[place_of(scalar)]);
    }

    std::optional<Histogram> histogram(const ScalarName& scalar, std::size_t step) const override {
        auto ranges = value_ranges(scalar.array, step);
        if (!ranges || ranges->histograms.empty()) return std::nullopt;
        return std::move(ranges->histograms[place_of(scalar)]);
    }

    std::optional<ciel::BlockBoxes> block_boxes(std::size_t mesh, std::size_t coordinates) const override {
        const auto& sums = coordinate_checksums_.at(mesh);
        if (coordinates >= sums.size()) return std::nullopt;
        auto ranges = position_ranges(mesh, coordinates, sums[coordinates]);
        if (!ranges) return std::nullopt;
        std::vector<ciel::BlockRanges>& axes = ranges->scalars;
        return ciel::BlockBoxes{std::move(axes[0]), std::move(axes[1]), std::move(axes[2])};
    }

    std::size_t memory_bytes() const override { return chunks_->memory_bytes(); }

    Values values(const std::string& array, std::size_t step) const override {
        return loaded(values_to_load(array, step));
    }
    ValuesToLoad values_to_load(const std::string& array, std::size_t step) const override {
        if (find(array) == nullptr) refuse(directory_, "has no array '" + array + "'");
        if (step >= steps_->size()) refuse(directory_, "has no step " + std::to_string(step));
        const MarkedStep at = marked(step);
        const auto entry = at.arrays.find(array);
        if (entry == at.arrays.end()) return {};
        check_chunk(at.mesh, array, entry->second.chunk);
        if (entry->second.late)
            refuse(directory_, "array '" + array + "' has not been read from its source yet at time " +
                                   std::to_string(at.time) + "; read it with 'ciel import " +
                                   directory_.filename().string() + " --step " + std::to_string(step) + "'");
        return array_to_load(at.mesh, array, entry->second);
    }
    std::map<std::string, std::uint64_t> late_chunks(std::size_t step) const override {
        std::map<std::string, std::uint64_t> late;
        for (const auto& [name, array] : marked(step).arrays)
            if (array.late) late.emplace(name, array.chunk);
        return late;
    }

private:
    // `positions`: the owner of the positions and of the loader.
    ciel::FaceMeshView of_dataset(ciel::FaceMeshView view, std::size_t mesh,
                                  std::shared_ptr<const void> positions) const {
        using Owners = std::pair<std::shared_ptr<const MappedMesh>, std::shared_ptr<const void>>;
        view.surface_origin = middle_of(info_.meshes[mesh]);
        view.keep_alive = std::make_shared<const Owners>(meshes_[mesh], std::move(positions));
        return view;
    }

    // All fields on the same positions share one loader, because the loader records which blocks are loaded.
    std::shared_ptr<const PositionsLoader> loader_of(const ValuesToLoad& positions, std::size_t mesh,
                                                     std::size_t coordinates) const {
        const std::lock_guard lock(loaders_mutex_);
        std::weak_ptr<const PositionsLoader>& known = loaders_[{mesh, coordinates}];
        auto loader = known.lock();
        if (!loader) known = loader = std::make_shared<const PositionsLoader>(positions, at(mesh)->block_count());
        return loader;
    }

    ValuesToLoad array_to_load(std::size_t mesh, const std::string& array, const MarkedArray& entry) const {
        const ArrayLayout shape = late_files_.layout_of(layouts_[mesh].at(array), entry.chunk);
        const auto checks = [&] {
            return checks_of_stretches(shape, entry.checksum, stored_ranges(mesh, array, entry));
        };
        return view_of(chunks_->get(shape.chunk(entry.chunk), shape.chunk_bytes, checks), shape.doubles);
    }

    ValuesToLoad positions_to_load(std::size_t mesh, std::size_t coordinates) const {
        (void)at(mesh); // throws for an unknown mesh
        const ArrayLayout& shape = positions_[mesh];
        if (coordinates >= shape.chunks)
            refuse(shape.directory, "has no coordinate set " + std::to_string(coordinates));
        const fs::path file = shape.chunk(coordinates);
        const auto checks = [&] {
            const auto& sums = coordinate_checksums_[mesh];
            const std::string sum = coordinates < sums.size() ? sums[coordinates] : std::string();
            StretchChecks made = checks_of_stretches(shape, sum, position_ranges(mesh, coordinates, sum));
            made.numbers = [file, doubles = shape.doubles](auto stretch) { refuse_infinite(stretch, doubles, file); };
            return made;
        };
        return view_of(chunks_->get(file, shape.chunk_bytes, checks), shape.doubles);
    }
    Values positions(std::size_t mesh, std::size_t coordinates) const {
        return loaded(positions_to_load(mesh, coordinates));
    }

    std::size_t place_of(const ScalarName& scalar) const {
        const std::vector<ScalarName> scalars = scalars_of(*find(scalar.array));
        return static_cast<std::size_t>(std::ranges::find(scalars, scalar) - scalars.begin());
    }

    std::optional<ValueRanges> value_ranges(const std::string& array, std::size_t step) const {
        const MarkedStep at = marked(step);
        const auto entry = at.arrays.find(array);
        if (entry == at.arrays.end()) return std::nullopt;
        check_chunk(at.mesh, array, entry->second.chunk);
        return stored_ranges(at.mesh, array, entry->second);
    }
    std::optional<ValueRanges> stored_ranges(std::size_t mesh, const std::string& array,
                                             const MarkedArray& entry) const {
        if (!meshes_[mesh]->has_blocks()) return std::nullopt;
        const ArrayInfo& info = *find(array);
        const std::size_t blocks = info.association == Association::point ? meshes_[mesh]->block_count() : 0;
        return read_ranges(late_files_.layout_of(layouts_[mesh].at(array), entry.chunk), entry.chunk, entry.checksum,
                           scalars_of(info).size(), blocks, info_.id);
    }
    std::optional<ValueRanges> position_ranges(std::size_t mesh, std::size_t coordinates,
                                               const std::string& sum) const {
        if (!meshes_[mesh]->has_blocks()) return std::nullopt;
        return read_ranges(positions_[mesh], coordinates, sum, 3, meshes_[mesh]->block_count(), info_.id);
    }
    const std::shared_ptr<MappedMesh>& at(std::size_t mesh) const {
        if (mesh >= meshes_.size()) refuse(directory_, "has no mesh " + std::to_string(mesh));
        return meshes_[mesh];
    }

    // A refresh (`before` is not null) reads the attributes again, because a writer may have added coordinate sets.
    std::vector<std::string> coordinate_checksums(std::size_t mesh, const MappedDataset* before) const {
        if (before == nullptr || mesh >= before->meshes_.size())
            return meshes_[mesh]->attributes().coordinate_checksums;
        const auto file = meshes_[mesh]->directory() / layout::attributes_document;
        return parse_mesh_attributes(read_text(file, layout::document_bytes), file).coordinate_checksums;
    }

    MarkedStep as_marked(std::size_t step) const {
        return step < table_->size() ? table_->step(step) : marker_.steps.at(step - table_->size());
    }
    MarkedStep marked(std::size_t step) const {
        MarkedStep found = as_marked(step);
        late_files_.complete(found, layouts_.at(found.mesh));
        return found;
    }
    // While some late arrays of a step are not written yet, returns all of them as late.
    MarkedStep marked_whole(std::size_t step) const {
        MarkedStep found = marked(step);
        const bool is_whole = std::ranges::none_of(found.arrays, [](const auto& array) { return array.second.late; });
        return is_whole ? found : as_marked(step);
    }

    std::vector<double> times() const {
        std::vector<double> times;
        for (std::size_t step = 0; step < table_->size(); ++step) times.push_back(table_->time(step));
        for (const MarkedStep& step : marker_.steps) times.push_back(step.time);
        if (table_->size() > 0 && !marker_.steps.empty() && !(times[table_->size()] > times[table_->size() - 1]))
            refuse(directory_ / layout::commit_marker,
                   "has a step that is not later than the last step in the table of steps");
        return times;
    }

    Step read_step(std::size_t index, LackingRanges lacking) const {
        const MarkedStep from = marked_whole(index);
        check_coordinates(index, from);
        Step step{from.time, from.mesh, from.coordinates, {}};
        for (const auto& [name, entry] : from.arrays) {
            check_chunk(from.mesh, name, entry.chunk);
            step.arrays.emplace(name, array_step(from, name, entry, lacking));
        }
        return step;
    }

    void check_coordinates(std::size_t index, const MarkedStep& step) const {
        if (step.coordinates >= positions_[step.mesh].chunks)
            refuse(directory_ / layout::commit_marker,
                   "step " + std::to_string(index) + " uses a coordinate set that does not exist");
    }

    void learn_arrays(std::size_t index, const MarkedStep& step) {
        check_coordinates(index, step);
        for (const auto& [name, entry] : step.arrays) learn_array(step.mesh, name);
    }

    void learn_arrays_of_table() {
        for (const TableArray& array : marker_.table.arrays)
            for (const std::uint64_t mesh : array.meshes) learn_array(mesh, array.name);
    }

    void learn_array(std::size_t mesh, const std::string& name) {
        if (layouts_[mesh].contains(name)) return;
        const auto directory = layout::values(meshes_[mesh]->directory(), name);
        const auto document = directory / layout::attributes_document;
        ArrayInfo array = parse_array_attributes(read_text(document, layout::document_bytes), document);
        if (array.name != name)
            refuse(document, "is named '" + array.name + "', but the commit marker lists the array as '" + name + "'");
        const std::uint64_t items = items_of(meshes_[mesh]->attributes().info, array.association);
        array.doubles =
            layouts_[mesh].emplace(name, read_layout(directory, items, array.components)).first->second.doubles;
        const ArrayInfo* known = find(name);
        if (known == nullptr)
            info_.arrays.push_back(array);
        else if (!known->has_shape_of(array) || known->doubles != array.doubles)
            refuse(document, "has another association, number of components or type than on an earlier mesh");
    }

    void check_chunk(std::size_t mesh, const std::string& name, std::uint64_t chunk) const {
        const auto layout = layouts_[mesh].find(name);
        if (layout == layouts_[mesh].end())
            refuse_damage(directory_, "has no array '" + name + "' on mesh " + std::to_string(mesh) +
                                          ", but the table of steps lists it");
        if (chunk >= layout->second.chunks)
            refuse(layout->second.directory / layout::array_document,
                   "declares " + std::to_string(layout->second.chunks) + " steps, but the commit marker lists step " +
                       std::to_string(chunk));
    }

    void check_extremes(const MarkedStep& step, const ArrayInfo& array,
                        const std::vector<CellExtremes>& extremes) const {
        if (extremes.empty()) return;
        const std::uint64_t cells = meshes_[step.mesh]->cell_count();
        const auto exists = [&](const CellExtremes& each) {
            return each.lowest.cell < cells && each.highest.cell < cells;
        };
        const std::size_t wanted = array.components == 1 ? 1 : 1 + static_cast<std::size_t>(array.components);
        if (extremes.size() != wanted || array.association != Association::cell ||
            !std::all_of(extremes.begin(), extremes.end(), exists))
            refuse(directory_ / layout::commit_marker,
                   "'extremes' of '" + array.name +
                       "' must be cells of the mesh, first for the array's range and then for each component");
    }

    ArrayStep array_step(const MarkedStep& step, const std::string& name, const MarkedArray& entry,
                         LackingRanges lacking) const {
        const ArrayInfo& array = *find(name);
        ArrayStep result;
        if (entry.statistics) {
            result = *entry.statistics;
            const auto components = static_cast<std::size_t>(array.components);
            if (result.component_ranges.size() != components)
                refuse(directory_ / layout::commit_marker,
                       "'component_ranges' of '" + name + "' must have one entry per component");
            check_extremes(step, array, result.extremes);
        } else if (lacking == LackingRanges::left_out || entry.late) {
            result.component_ranges.resize(static_cast<std::size_t>(array.components));
        } else {
            result = statistics(loaded(array_to_load(step.mesh, name, entry)), array);
            result.extremes.clear(); // left empty, because computing the positions of the cells would read blocks
        }
        result.late = entry.late;
        result.has_checksum = !entry.checksum.empty();
        return result;
    }

    fs::path directory_;
    DatasetInfo info_;
    Marker marker_;
    std::unique_ptr<const StepTable> table_;
    std::unique_ptr<const Steps> steps_; // steps of the table, then steps of the marker
    std::vector<std::shared_ptr<MappedMesh>> meshes_;
    std::vector<ArrayLayout> positions_;                         // per mesh
    std::vector<std::vector<std::string>> coordinate_checksums_; // per mesh, per coordinate set
    std::vector<std::map<std::string, ArrayLayout>> layouts_;    // per mesh, by array name
    LossCount losses_; // shared with refreshed versions, like the mapped files
    LossCheck loss_check_{losses_};
    mutable std::mutex loaders_mutex_;
    // Key: mesh, coordinate set.
    mutable std::map<std::pair<std::size_t, std::size_t>, std::weak_ptr<const PositionsLoader>> loaders_;
    fs::path late_folder_;
    LateFiles late_files_;
    std::uint64_t late_changes_; // LateFiles::changes() when the dataset was opened or refreshed
    FileAccess access_;
    std::shared_ptr<ChunkCache> chunks_ = std::make_shared<ChunkCache>(losses_, access_);
};

} // namespace

std::shared_ptr<Dataset> Dataset::open(const fs::path& directory, LackingRanges lacking,
                                       std::optional<FileAccess> access, const fs::path& late_folder) {
    return std::make_shared<MappedDataset>(directory, read_documents(directory), lacking,
                                           access ? *access : access_to(directory), late_folder, nullptr);
}

std::uint64_t items_of(const MeshInfo& mesh, Association association) {
    switch (association) {
    case Association::point:
        return mesh.vertices;
    case Association::cell:
        return mesh.cells;
    case Association::boundary_face:
        return mesh.boundary_faces;
    }
    return 0;
}

ciel::Vec3d middle_of(const MeshInfo& mesh) {
    ciel::Vec3d middle{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        middle[axis] = mesh.bounds[2 * axis] / 2 + mesh.bounds[2 * axis + 1] / 2;
    return middle;
}

bool Dataset::is_intact() const {
    try {
        check_intact();
        return true;
    } catch (const ciel::Error&) {
        return false;
    }
}

const ArrayInfo* Dataset::find(const std::string& array) const {
    const auto& arrays = info().arrays;
    const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const ArrayInfo& a) { return a.name == array; });
    return found == arrays.end() ? nullptr : &*found;
}

std::size_t Dataset::step_at(double time) const {
    const auto times = steps().times();
    if (std::isnan(time)) return 0;
    const auto after = std::ranges::upper_bound(times, time);
    if (after == times.begin()) return 0;
    const auto step = static_cast<std::size_t>(after - times.begin()) - 1;
    return step + 1 < times.size() && times[step + 1] - time < time - times[step] ? step + 1 : step;
}

} // namespace server::store
