// A dataset in memory for all sessions: one Topology per mesh, one Field per scalar and step while somebody uses it.
#pragma once

#include "ciel/field.hpp"
#include "store/dataset.hpp"

namespace ciel::store {

// What a query needs of one scalar at one step; keeps everything it points to alive.
struct ScalarField {
    std::shared_ptr<const Topology> topology;
    std::shared_ptr<const Field> field;
    FaceMeshView mesh;
    std::shared_ptr<const void> keep_alive;
};

// Cells without a number that is none: what blew up is shown nowhere.
struct SoundCells {
    std::vector<std::uint8_t> kept; // a flag per cell
    std::size_t left_out = 0;
};

// An array has no values at a step: nothing is wrong, but nothing can be shown of it.
class NotWritten : public Error {
    using Error::Error;
};

// Thread-safe. Fields are kept in a least-recently-used cache of `field_budget_bytes`.
class LoadedDataset {
public:
    LoadedDataset(std::shared_ptr<Dataset> dataset, std::size_t field_budget_bytes);
    ~LoadedDataset();

    [[nodiscard]] std::shared_ptr<Dataset> dataset() const; // the newest refresh
    bool refresh();                                         // true when steps were added

    [[nodiscard]] std::shared_ptr<const Topology> topology(std::size_t mesh);
    // Throws NotWritten, and Error when the scalar does not exist or has no values at points.
    [[nodiscard]] ScalarField scalar(const std::string& name, std::size_t step);
    // Point scalar by name as a plain array (magnitudes and components are made once), for coloring and probing.
    [[nodiscard]] std::shared_ptr<const std::vector<float>> scalar_values(const std::string& name, std::size_t step);
    // Likewise of an array of the cells or of the boundary's faces: one value each.
    [[nodiscard]] std::shared_ptr<const std::vector<float>> cell_values(const std::string& name, std::size_t step);
    [[nodiscard]] std::shared_ptr<const std::vector<float>> face_values(const std::string& name, std::size_t step);
    // All cells but those where the array of the scalar went wrong at the step, in any component; null where none did.
    // An array on points that was made from the cells is judged by the values of the cells. An array of patches is
    // judged by the values of the cells and of its faces.
    [[nodiscard]] std::shared_ptr<const SoundCells> sound_cells(const std::string& name, std::size_t step);
    // How many cells have a corner whose value went wrong, of an array that the file has on points: what is cut leaves
    // them out.
    [[nodiscard]] std::size_t cells_with_bad_corners(const std::string& name, std::size_t step);
    // nu = dot(normal, position - origin).
    [[nodiscard]] ScalarField plane(std::size_t step, Vec3d origin, Vec3d normal);

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace ciel::store
