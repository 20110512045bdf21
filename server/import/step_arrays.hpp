// The arrays of one step in stored order, named as in the dataset: point data as it came, cell data as "cell:NAME",
// and point data made from cell data.
#pragma once

#include "import/fields.hpp"
#include "import/point_interpolation.hpp"
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
    // `selected` empty: all; "p" selects p and cell:p. Names that were found are added to `found`.
    StepArrays(const std::vector<std::string>& selected, std::map<std::string, std::string> units)
        : selected_(selected), units_(std::move(units)) {}

    // Valid until the next call.
    [[nodiscard]] const std::vector<store::ArrayValues>& make(const StepMesh& mesh, const Blocks& blocks,
                                                              std::unique_ptr<PointMaker>& maker);
    // Throws Error naming what the inputs have when something selected was at no step.
    void check_selection() const;

private:
    void add(const FieldName& field, const std::string& name, store::Association association,
             std::vector<float> values);
    void add_cell_field(const StepMesh& mesh, const Blocks& blocks, const FieldName& field, bool point_field_exists,
                        std::unique_ptr<PointMaker>& maker);
    [[nodiscard]] bool wanted(const std::string& field, bool cell_only) const;

    std::vector<std::string> selected_;
    std::map<std::string, std::string> units_;
    std::set<std::string> seen_;
    std::vector<bool> no_slip_;
    std::deque<std::vector<float>> values_;
    std::vector<store::ArrayValues> arrays_;
};

// The name in the dataset: ':' separates a component there ("U:x").
[[nodiscard]] std::string stored_name(const std::string& name);

} // namespace ciel::importer
