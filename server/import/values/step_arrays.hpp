// The arrays of one step in stored order, named as in the dataset: point data as it came, cell data as "cell:NAME",
// point data made from cell data, and what patches have on their faces as "patch:NAME".
#pragma once

#include "ciel/point_interpolation.hpp"
#include "import/mesh/step_mesh.hpp"
#include "import/source/source.hpp"
#include "import/values/field_components.hpp"
#include "import/values/fields.hpp"
#include "import/values/patch_faces.hpp"
#include "import/values/value_loss.hpp"
#include "import/values/wall_values.hpp"

#include <deque>
#include <memory>
#include <set>

namespace ciel::importer {

// Made once per mesh and coordinates, when first needed.
struct PointMaker {
    PointInterpolation interpolation;
    WallValues walls;
    PatchFaces patch_faces;
};

class StepArrays {
public:
    // Arrays of no interest to `selection` are left out, and all are shown to it.
    StepArrays(ArraySelection& selection, const Source& source, FieldComponents components)
        : selection_(selection), source_(source), units_(source.units()), components_(std::move(components)) {}

    // Of the step that the source has read last. Valid until the next call.
    [[nodiscard]] const std::vector<store::ArrayValues>&
    make(std::size_t step, const StepMesh& mesh, const DataSets& data_sets, std::unique_ptr<PointMaker>& maker);

    // Sentences on what is left out of all steps so far, and on what floats have lost.
    [[nodiscard]] std::vector<std::string> notes() const;
    // Likewise on what should be in the dataset.
    [[nodiscard]] std::vector<std::string> lost() const { return {lost_.begin(), lost_.end()}; }
    [[nodiscard]] const FieldComponents& components() const { return components_; }

private:
    void add(const FieldName& field, const std::string& name, store::Association association, store::Origin origin,
             std::vector<float> values);
    [[nodiscard]] bool accept(FieldName& field, const std::string& stored);
    [[nodiscard]] store::Origin origin_of(const FieldName& field) const;
    void add_cell_field(const StepMesh& mesh, const DataSets& data_sets, FieldName field, bool point_field_exists,
                        std::unique_ptr<PointMaker>& maker);
    void note_unknown_conditions(const StepMesh& mesh, const DataSets& data_sets, const FieldName& field);

    ArraySelection& selection_;
    const Source& source_;
    std::map<std::string, std::string> units_;
    FieldComponents components_;
    std::map<std::string, std::vector<std::string>> order_; // of a tensor's components, by name in the dataset
    std::size_t step_ = 0;
    ValueLoss loss_;
    std::set<std::string> notes_, lost_;
    std::vector<bool> no_slip_;
    std::deque<std::vector<float>> values_;
    std::vector<store::ArrayValues> arrays_;
};

} // namespace ciel::importer
