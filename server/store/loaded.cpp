#include "store/loaded.hpp"

#include "ciel/geometric_vertices.hpp"
#include "ciel/mesh_faces.hpp"
#include "store/cache/cache.hpp"
#include "store/mesh_arrays.hpp"
#include "store/no_value.hpp"

#include <algorithm>
#include <mutex>
#include <sstream>

namespace server::store {
namespace {

struct KeptField {
    std::shared_ptr<const ciel::Topology> topology; // used by queries of the field
    ciel::Field field;
};

// Counts gradients, and two values per vertex: an estimate, because block order repeats shared vertices.
std::size_t field_bytes(std::uint64_t vertices, std::size_t value_bytes) {
    return vertices * (2 * value_bytes + sizeof(ciel::Vec3f));
}

const char* name_of(Association association) {
    switch (association) {
    case Association::point:
        return "points";
    case Association::cell:
        return "cells";
    case Association::boundary_face:
        break;
    }
    return "the faces of patches";
}

// Returns the cell array of a point or patch array, or null. It shows which cells have NaN or infinite results.
const ArrayInfo* cells_of(const Dataset& dataset, const ArrayInfo& array) {
    constexpr std::string_view patch = "patch:";
    const bool of_patches = array.association == Association::boundary_face && array.name.starts_with(patch);
    const std::string name =
        of_patches ? "cell:" + array.name.substr(patch.size()) : cell_scalar(dataset, scalar_names(array).front());
    if (name.empty()) return nullptr;
    const ArrayInfo* cells = of_patches ? dataset.find(name) : dataset.find(parse_scalar(dataset, name).array);
    return cells != nullptr && cells->association == Association::cell ? cells : nullptr;
}

bool any_went_wrong(const Step& step, const ArrayInfo* array) {
    if (array == nullptr) return false;
    const auto written = step.arrays.find(array->name);
    return written != step.arrays.end() && written->second.invalid > 0;
}

bool went_wrong_at(ciel::ValuesView values, std::size_t width, std::size_t item) {
    return std::ranges::any_of(values.subview(width * item, width), went_wrong);
}

void leave_out_cells(const ArrayInfo& array, ciel::ValuesView values, std::vector<std::uint8_t>& kept) {
    const auto width = static_cast<std::size_t>(array.components);
    for (std::size_t cell = 0; cell < kept.size(); ++cell)
        if (went_wrong_at(values, width, cell)) kept[cell] = 0;
}

void leave_out_owners(const ciel::FaceMeshView& boundary, const ArrayInfo& array, ciel::ValuesView values,
                      std::vector<std::uint8_t>& kept) {
    const auto width = static_cast<std::size_t>(array.components);
    for (ciel::Index number = 0; number < boundary.face_count(); ++number)
        if (went_wrong_at(values, width, number)) kept[boundary.owner[number]] = 0;
}

std::string step_key(const char* kind, const std::string& name, std::size_t step) {
    return std::string(kind) + "/" + std::to_string(step) + "/" + name;
}

std::string times_written(const Dataset& dataset, const std::string& array) {
    constexpr std::size_t most = 5;
    std::ostringstream text;
    std::size_t found = 0;
    for (const Step& step : dataset.steps())
        if (step.arrays.count(array) > 0 && ++found <= most) text << (found > 1 ? ", " : "") << step.time;
    if (found > most) text << " and " << found - most << " more";
    return text.str();
}

} // namespace

struct LoadedDataset::State {
    // One plane is enough: a slice that the user turns needs another one for each picture, and layers hold theirs.
    static constexpr std::size_t most_planes = 1;

    State(std::shared_ptr<Dataset> first, std::size_t budget, AskForStep asking)
        : dataset(std::move(first)), ask(std::move(asking)), most_fit_bytes(budget / 4), fields(budget / 4 * 3),
          planes(budget / 4, most_planes) {}

    struct MeshSlot {
        std::mutex making;
        std::shared_ptr<const ciel::Topology> topology;
        // Keys of both maps: index of the coordinate set.
        std::map<std::size_t, std::shared_ptr<const ciel::GeometricVertices>> geometric;
        std::map<std::size_t, std::shared_ptr<const ciel::BlockBoxes>> boxes;
    };

    [[nodiscard]] std::shared_ptr<Dataset> current() const {
        const std::lock_guard lock(mutex);
        return dataset;
    }

    [[nodiscard]] std::shared_ptr<MeshSlot> slot(std::size_t mesh) {
        const std::lock_guard lock(mutex);
        auto& found = meshes[mesh];
        if (!found) found = std::make_shared<MeshSlot>();
        return found;
    }

    [[nodiscard]] ValuesToLoad written(const Dataset& of, const std::string& array, std::size_t step,
                                       Association wanted) const {
        if (const Association own = of.find(array)->association; own != wanted)
            throw ciel::Error("'" + array + "' is an array on " + name_of(own) + "; choose an array on " +
                              name_of(wanted));
        check_read(of, array, step);
        auto values = of.values_to_load(array, step);
        if (values.file == nullptr) {
            std::ostringstream time;
            time << of.steps()[step].time;
            throw NotWritten("'" + array + "' has no values at time " + time.str() + "; it has values at " +
                             times_written(of, array));
        }
        return values;
    }

    // A late array that has been written stays late until the next refresh, because its ranges are not known before.
    void check_read(const Dataset& of, const std::string& array, std::size_t step) const {
        const Step& at = of.steps()[step];
        const auto found = at.arrays.find(array);
        if (found == at.arrays.end() || !found->second.late) return;
        const LateAnswer answer =
            ask ? ask(of, step) : LateAnswer{"has not been read from its source; use `ciel import --step`", true};
        std::ostringstream time;
        time << at.time;
        throw NotYetRead("'" + array + "' at time " + time.str() + " " + answer.words, answer.has_failed);
    }

    [[nodiscard]] static const Step& step_of(const Dataset& dataset, std::size_t step) {
        if (step >= dataset.steps().size())
            throw ciel::Error("dataset '" + dataset.info().name + "' has no step " + std::to_string(step) +
                              "; the number of its steps is " + std::to_string(dataset.steps().size()));
        return dataset.steps()[step];
    }

    [[nodiscard]] std::shared_ptr<const ciel::GeometricVertices> geometric(const std::shared_ptr<Dataset>& of,
                                                                           const Step& at) {
        const auto kept = slot(at.mesh);
        const std::lock_guard making(kept->making);
        auto& found = kept->geometric[at.coordinates];
        if (!found)
            found = std::make_shared<const ciel::GeometricVertices>(
                [of, at_mesh = at.mesh, at_coordinates = at.coordinates] {
                    ciel::FaceMeshView boundary = of->mesh_arrays().boundary(at_mesh, at_coordinates);
                    const ciel::FaceMeshView points =
                        of->mesh_arrays().points(at_mesh, at_coordinates); // reads all positions
                    boundary.positions = points.positions;
                    boundary.loader = points.loader;
                    boundary.keep_alive = points.keep_alive;
                    return boundary;
                });
        return found;
    }

    [[nodiscard]] std::shared_ptr<const ciel::BlockBoxes> boxes(const Dataset& of, const Step& at,
                                                                const ciel::Topology& topology) {
        const auto kept = slot(at.mesh);
        const std::lock_guard making(kept->making);
        auto& found = kept->boxes[at.coordinates];
        if (found) return found;
        auto stored = of.block_boxes(at.mesh, at.coordinates);
        if (!stored) stored = ciel::block_boxes(topology, of.mesh_arrays().points(at.mesh, at.coordinates).positions);
        return found = std::make_shared<const ciel::BlockBoxes>(*std::move(stored));
    }

    // Keeps the fits of one coordinate set only, because a moving mesh would otherwise keep fits for each step.
    [[nodiscard]] std::shared_ptr<ciel::CellFits> cell_fits(const Step& at,
                                                            const std::shared_ptr<const ciel::Topology>& topology) {
        const std::lock_guard lock(mutex);
        const std::array<std::size_t, 2> place{at.mesh, at.coordinates};
        if (fits && fitted == place) return fits;
        if (fits) fits->forget();
        fitted = place;
        fitted_topology = topology;
        return fits = std::make_shared<ciel::CellFits>(*topology, most_fit_bytes);
    }

    // `bytes`: size of the field and of all data that it keeps alive.
    [[nodiscard]] static ScalarField field(Cache& cache, const std::shared_ptr<Dataset>& of, std::size_t step,
                                           const std::string& key,
                                           const std::shared_ptr<const ciel::Topology>& topology, std::size_t bytes,
                                           const std::function<ciel::Field()>& make) {
        const Step& at = of->steps()[step];
        const auto kept = cache.get<KeptField>(key, [&]() -> Cache::Made {
            return {std::make_shared<KeptField>(KeptField{topology, make()}), bytes};
        });
        of->check_intact();
        // Returns the cached field's topology, not `topology`, because the field may be older than the last refresh.
        return {
            kept->topology, {kept, &kept->field}, of->mesh_arrays().points_to_load(at.mesh, at.coordinates), of, step};
    }

    mutable std::mutex mutex;
    std::shared_ptr<Dataset> dataset;
    const AskForStep ask;
    std::map<std::size_t, std::shared_ptr<MeshSlot>> meshes;
    std::mutex refreshing;
    const std::size_t most_fit_bytes;
    std::shared_ptr<ciel::CellFits> fits; // fits for the mesh and the coordinate set in `fitted`
    std::array<std::size_t, 2> fitted{};
    std::shared_ptr<const ciel::Topology> fitted_topology;
    Cache fields, planes;
};

LoadedDataset::LoadedDataset(std::shared_ptr<Dataset> dataset, std::size_t field_budget_bytes, AskForStep ask)
    : state_(std::make_unique<State>(std::move(dataset), field_budget_bytes, std::move(ask))) {}

LoadedDataset::~LoadedDataset() = default;

std::shared_ptr<Dataset> LoadedDataset::dataset() const { return state_->current(); }

bool LoadedDataset::refresh() {
    const std::lock_guard one_at_a_time(state_->refreshing);
    auto now = state_->current()->refreshed();
    if (!now) return false;
    const std::lock_guard lock(state_->mutex);
    state_->dataset = std::move(now);
    return true;
}

std::shared_ptr<const ciel::Topology> LoadedDataset::topology(std::size_t mesh) {
    const auto slot = state_->slot(mesh);
    const std::lock_guard making(slot->making);
    if (slot->topology) return slot->topology;
    const auto of = state_->current();
    auto made = of->naming_changed_file([&] { return std::make_shared<const ciel::Topology>(of->topology(mesh)); });
    of->check_unchanged();
    return slot->topology = std::move(made);
}

std::shared_ptr<const StoredScalar> LoadedDataset::stored_scalar(const std::string& name, std::size_t step,
                                                                 Association items) {
    const auto of = state_->current();
    (void)State::step_of(*of, step);
    ScalarName scalar = parse_scalar(*of, name);
    const ArrayInfo& array = *of->find(scalar.array);
    ValuesToLoad values = state_->written(*of, scalar.array, step, items);
    return std::make_shared<const StoredScalar>(array, std::move(scalar), std::move(values));
}

void LoadedDataset::require_read(std::size_t step) const {
    const auto of = state_->current();
    for (const auto& [array, facts] : State::step_of(*of, step).arrays)
        if (facts.late) state_->check_read(*of, array, step);
}

ScalarField LoadedDataset::scalar(const std::string& name, std::size_t step) {
    const auto of = state_->current();
    const Step& at = State::step_of(*of, step);
    const auto source = stored_scalar(name, step);
    const auto of_mesh = topology(at.mesh);
    const std::size_t bytes = field_bytes(source->size(), source->has_doubles() ? sizeof(double) : sizeof(float));
    return State::field(state_->fields, of, step, step_key("field", name, step), of_mesh, bytes, [&] {
        auto ranges = of->block_ranges(parse_scalar(*of, name), step);
        if (!ranges) ranges = ciel::block_ranges(*of_mesh, source->all());
        ciel::Field made(*of_mesh, source, *std::move(ranges));
        made.set_cell_fits(state_->cell_fits(at, of_mesh));
        return made;
    });
}

Values LoadedDataset::scalar_values(const std::string& name, std::size_t step) {
    const auto of = state_->current();
    const auto stored = stored_scalar(name, step);
    const auto made = state_->fields.get<Values>(step_key("values", name, step), [&]() -> Cache::Made {
        const auto all = std::make_shared<Values>(stored->all());
        return {all, stored->copies_all() ? all->size_bytes() : 0};
    });
    of->check_intact();
    return {*made, made}; // the result keeps the cached values in use
}

Histogram LoadedDataset::histogram(const std::string& name, std::size_t step, std::size_t bins,
                                   std::optional<std::array<double, 2>> range, const ValuesRead& values_read) {
    const auto of = state_->current();
    (void)State::step_of(*of, step);
    const ScalarName scalar = parse_scalar(*of, name);
    const auto values = stored_scalar(name, step, of->find(scalar.array)->association);
    if (!range)
        if (const auto stored = of->histogram(scalar, step))
            if (auto fewer = stored->with_bins(bins)) return *std::move(fewer);
    return values->histogram(bins, range, values_read);
}

std::shared_ptr<const SoundCells> LoadedDataset::sound_cells(const std::string& name, std::size_t step) {
    const auto of = state_->current();
    const Step& at = State::step_of(*of, step);
    const ArrayInfo& array = *of->find(parse_scalar(*of, name).array);
    const ArrayInfo* cells = cells_of(*of, array);
    const ArrayInfo* faces = array.association == Association::boundary_face ? &array : nullptr;
    if (!any_went_wrong(at, cells) && !any_went_wrong(at, faces)) return nullptr;
    auto sound = state_->fields.get<SoundCells>(step_key("sound", array.name, step), [&]() -> Cache::Made {
        auto made = std::make_shared<SoundCells>();
        made->kept.assign(of->info().meshes[at.mesh].cells, 1);
        if (any_went_wrong(at, cells)) leave_out_cells(*cells, of->values(cells->name, step), made->kept);
        if (any_went_wrong(at, faces))
            leave_out_owners(of->mesh_arrays().boundary(at.mesh, at.coordinates), *faces, of->values(faces->name, step),
                             made->kept);
        made->left_out = static_cast<std::size_t>(std::ranges::count(made->kept, 0));
        return {made, made->kept.size()};
    });
    of->check_intact();
    return sound->left_out > 0 ? sound : nullptr;
}

std::size_t LoadedDataset::cells_with_bad_corners(const std::string& name, std::size_t step) {
    const auto of = state_->current();
    const Step& at = State::step_of(*of, step);
    const ArrayInfo& array = *of->find(parse_scalar(*of, name).array);
    if (array.association != Association::point || cells_of(*of, array) != nullptr || !any_went_wrong(at, &array))
        return 0;
    const ScalarField of_scalar = scalar(name, step);
    const Values values = scalar_values(name, step);
    const auto counted = state_->fields.get<std::size_t>(step_key("bad corners", name, step), [&]() -> Cache::Made {
        return {std::make_shared<std::size_t>(ciel::count_cells_without_value(*of_scalar.field, values, went_wrong)),
                sizeof(std::size_t)};
    });
    of->check_intact();
    return *counted;
}

std::shared_ptr<const ciel::CellLocator> LoadedDataset::locator(std::size_t step) {
    const auto of = state_->current();
    const Step& at = State::step_of(*of, step);
    const auto of_mesh = topology(at.mesh);
    return std::make_shared<const ciel::CellLocator>(
        *of_mesh, of->mesh_arrays().points_to_load(at.mesh, at.coordinates), state_->boxes(*of, at, *of_mesh));
}

std::shared_ptr<const ciel::BlockBoxes> LoadedDataset::boxes(std::size_t step) {
    const auto of = state_->current();
    const Step& at = State::step_of(*of, step);
    return state_->boxes(*of, at, *topology(at.mesh));
}

ScalarField LoadedDataset::plane(std::size_t step, ciel::Vec3d origin, ciel::Vec3d normal) {
    const auto of = state_->current();
    const Step& at = State::step_of(*of, step);
    std::ostringstream key; // without the step: steps with the same mesh and coordinates share the field
    key << "plane/" << at.mesh << '/' << at.coordinates << std::hexfloat;
    for (const double x : {origin[0], origin[1], origin[2], normal[0], normal[1], normal[2]}) key << '/' << x;
    const auto of_mesh = topology(at.mesh);
    const auto boxes = state_->boxes(*of, at, *of_mesh);
    const std::size_t value_bytes = of->info().meshes[at.mesh].double_positions ? sizeof(double) : sizeof(float);
    const std::size_t bytes = field_bytes(of_mesh->counts().vertices, value_bytes);
    return State::field(state_->planes, of, step, key.str(), of_mesh, bytes, [&] {
        const ciel::FaceMeshView points = of->mesh_arrays().points_to_load(at.mesh, at.coordinates);
        ciel::Field made = ciel::Field::plane(*of_mesh, points, origin, normal, *boxes);
        made.set_direction(state_->geometric(of, at), normal);
        return made;
    });
}

ciel::Surface LoadedDataset::surface_of_faces(std::size_t step, std::vector<ciel::Index> numbers,
                                              std::span<const std::uint8_t> kept, const ciel::Vec3d& origin) {
    const auto of = state_->current();
    const Step& at = State::step_of(*of, step);
    ciel::FaceMeshView faces = of->mesh_arrays().numbered_faces(at.mesh, at.coordinates);
    faces.surface_origin = origin;
    return ciel::face_surface(faces, ciel::faces_by_id(faces, std::move(numbers), kept));
}

ciel::Surface LoadedDataset::boundary_surface(std::size_t step, std::span<const std::uint8_t> kept,
                                              const ciel::Vec3d& origin) {
    const auto of = state_->current();
    const Step& at = State::step_of(*of, step);
    ciel::FaceMeshView boundary = of->mesh_arrays().boundary(at.mesh, at.coordinates);
    boundary.surface_origin = origin;
    if (kept.empty()) return ciel::face_surface(boundary, ciel::boundary_faces(boundary));
    return ciel::threshold_surface(*topology(at.mesh), boundary, *boxes(step), kept);
}

ciel::Surface LoadedDataset::vertices_of_cells(std::size_t step, std::span<const std::uint8_t> kept,
                                               const ciel::Vec3d& origin) {
    const auto of = state_->current();
    const Step& at = State::step_of(*of, step);
    ciel::FaceMeshView points = of->mesh_arrays().points_to_load(at.mesh, at.coordinates);
    points.surface_origin = origin;
    return ciel::vertices_of_cells(*topology(at.mesh), points, kept);
}

void LoadedDataset::drop_unused_fields() {
    state_->fields.drop_unused();
    state_->planes.drop_unused();
}

std::size_t LoadedDataset::memory_bytes() const {
    std::size_t bytes = state_->fields.bytes() + state_->planes.bytes() + state_->current()->memory_bytes();
    const std::lock_guard lock(state_->mutex);
    if (state_->fits) bytes += state_->fits->memory_bytes();
    for (const auto& [index, slot] : state_->meshes) {
        // Does not wait for a topology that is being made, and does not count it.
        const std::unique_lock made(slot->making, std::try_to_lock);
        if (made && slot->topology) bytes += slot->topology->memory_bytes();
    }
    return bytes;
}

} // namespace server::store
