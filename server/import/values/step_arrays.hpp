// Makes the arrays of one step in the order of the dataset: point arrays, cell arrays ("cell:NAME"), point arrays
// interpolated from cell arrays, and values on patch faces ("patch:NAME").
#pragma once

#include "ciel/point_interpolation.hpp"
#include "import/mesh/step_mesh.hpp"
#include "import/source/source.hpp"
#include "import/values/field_components.hpp"
#include "import/values/fields.hpp"
#include "import/values/patch_faces.hpp"
#include "import/values/value_loss.hpp"
#include "import/values/wall_values.hpp"

#include <functional>
#include <memory>
#include <set>

namespace server::importer {

// Interpolates from cells and patches to points, for one mesh and one set of coordinates.
struct PointMaker {
    ciel::PointInterpolation interpolation;
    WallValues walls;
    PatchFaces patch_faces;
};

// Returns the topology of the step's mesh, which has been written.
using TopologyOf = std::function<const ciel::Topology&()>;

// Called for one array after the other, so that only the arrays that the receiver keeps are in memory.
using ArraySink = std::function<void(const store::ArrayInfo& info, store::Values values)>;

class StepArrays {
public:
    // Leaves out arrays that `selection` does not want, and calls selection.saw() for all arrays. `folder`: where the
    // interpolated values are, if they are large (store/files/disk_vector.hpp).
    StepArrays(ArraySelection& selection, const Source& source, FieldComponents components,
               std::filesystem::path folder)
        : selection_(selection), source_(source), folder_(std::move(folder)), units_(source.units()),
          components_(std::move(components)) {}

    // Makes the arrays of the step that was read last. Creates `maker` if it is needed.
    void make(std::size_t step, const StepMesh& mesh, const InputGrids& input_grids, const TopologyOf& topology,
              std::unique_ptr<PointMaker>& maker, const ArraySink& sink);

    // Returns notes on arrays left out, unknown boundary conditions, and values that the stored type changes.
    [[nodiscard]] std::vector<std::string> notes() const;
    // Returns sentences on arrays that should be in the dataset but are not.
    [[nodiscard]] std::vector<std::string> lost() const { return {lost_.begin(), lost_.end()}; }
    [[nodiscard]] const FieldComponents& components() const { return components_; }

private:
    void send(const FieldName& field, const std::string& name, store::Association association, store::Origin origin,
              store::Values values, const ArraySink& sink);
    [[nodiscard]] bool accept(FieldName& field, const std::string& stored);
    [[nodiscard]] store::Origin origin_of(const FieldName& field) const;
    void send_cell_field(const StepMesh& mesh, const InputGrids& input_grids, FieldName field, bool point_field_exists,
                         const TopologyOf& topology, std::unique_ptr<PointMaker>& maker, const ArraySink& sink);
    void note_unknown_conditions(const StepMesh& mesh, const InputGrids& input_grids, const FieldName& field);

    ArraySelection& selection_;
    const Source& source_;
    std::filesystem::path folder_;
    std::map<std::string, std::string> units_;
    FieldComponents components_;
    std::map<std::string, std::vector<std::string>> order_; // name in the dataset -> order of the tensor's components
    std::map<std::string, bool> doubles_; // name in the dataset -> whether it is float64, as at its first step
    std::size_t step_ = 0;
    ValueLoss loss_;
    std::set<std::string> notes_, lost_;
    std::vector<bool> no_slip_;
};

// The arrays of one step, all in memory.
class CollectedArrays {
public:
    void add(const store::ArrayInfo& info, store::Values values) {
        arrays_.push_back({info, values});
        values_.push_back(std::move(values));
    }
    [[nodiscard]] const std::vector<store::ArrayValues>& arrays() const { return arrays_; }

private:
    std::vector<store::ArrayValues> arrays_;
    std::vector<store::Values> values_; // keep the numbers of arrays_ alive
};

} // namespace server::importer
