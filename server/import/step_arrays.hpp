// The arrays of one step in stored order, named as in the dataset: point data as it came, cell data as "cell:NAME",
// and point data made from cell data.
#pragma once

#include "ciel/point_interpolation.hpp"
#include "import/fields.hpp"
#include "import/float_loss.hpp"
#include "import/step_mesh.hpp"
#include "import/wall_values.hpp"

#include <deque>
#include <memory>
#include <set>

namespace ciel::importer {

// Made once per mesh and coordinates, when first needed.
struct PointMaker {
    PointInterpolation interpolation;
    WallValues walls;
};

class StepArrays {
public:
    // Arrays of no interest to `selection` are left out, and all are shown to it.
    StepArrays(ArraySelection& selection, std::map<std::string, std::string> units)
        : selection_(selection), units_(std::move(units)) {}

    // Valid until the next call.
    [[nodiscard]] const std::vector<store::ArrayValues>& make(const StepMesh& mesh, const Blocks& blocks,
                                                              std::unique_ptr<PointMaker>& maker);

    // Sentences on what is left out of all steps so far, and on what floats have lost.
    [[nodiscard]] std::vector<std::string> notes() const;

private:
    void add(const FieldName& field, const std::string& name, store::Association association,
             std::vector<float> values);
    void add_cell_field(const StepMesh& mesh, const Blocks& blocks, const FieldName& field, bool point_field_exists,
                        std::unique_ptr<PointMaker>& maker);
    void note_unknown_conditions(const StepMesh& mesh, const Blocks& blocks, const FieldName& field);

    ArraySelection& selection_;
    std::map<std::string, std::string> units_;
    ValueLoss loss_;
    std::set<std::string> notes_;
    std::vector<bool> no_slip_;
    std::deque<std::vector<float>> values_;
    std::vector<store::ArrayValues> arrays_;
};

} // namespace ciel::importer
