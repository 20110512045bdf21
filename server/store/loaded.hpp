// LoadedDataset: a dataset in memory, shared by all sessions. Keeps one Topology per mesh and a cache of Fields.
#pragma once

#include "ciel/cell_locator.hpp"
#include "ciel/field.hpp"
#include "store/stored_scalar.hpp"

namespace ciel::store {

// Input of a Query for one scalar at one step. Keeps everything alive that it points to.
struct ScalarField {
    std::shared_ptr<const Topology> topology;
    std::shared_ptr<const Field> field;
    FaceMeshView points; // without faces; its surface_origin may be changed
    std::shared_ptr<const Dataset> dataset;
    std::size_t step = 0;

    // Returns the boundary faces with the surface_origin of `points`, and with positions to load. The faces are read
    // and checked at the first call for the mesh.
    [[nodiscard]] FaceMeshView boundary() const;
};

// Tells which cells have a NaN or infinite result of the solver in an array. Pictures leave these cells out.
struct SoundCells {
    std::vector<std::uint8_t> kept; // a flag per cell; 0: the cell has such a result
    std::size_t left_out = 0;       // number of cells whose flag is 0
};

// Error: the array was not written at this step. The dataset is intact.
class NotWritten : public Error {
    using Error::Error;
};

// Thread-safe. Of `field_budget_bytes`, three quarters are for a least-recently-used cache of fields, one quarter for a
// cache of the last planes. The fits of gradients (CellFits) get as much as the planes in addition.
class LoadedDataset {
public:
    LoadedDataset(std::shared_ptr<Dataset> dataset, std::size_t field_budget_bytes);
    ~LoadedDataset();

    [[nodiscard]] std::shared_ptr<Dataset> dataset() const; // with the steps of the last refresh()
    bool refresh();                                         // returns whether steps were added

    [[nodiscard]] std::shared_ptr<const Topology> topology(std::size_t mesh);
    // Returns the field of a scalar on points. Throws NotWritten when its array was not written at the step, Error when
    // the scalar does not exist or is not on points.
    [[nodiscard]] ScalarField scalar(const std::string& name, std::size_t step);
    // Returns a scalar whose values are read when they are needed. Throws like scalar(), and Error when it is not on
    // `items`.
    [[nodiscard]] std::shared_ptr<const StoredScalar> stored_scalar(const std::string& name, std::size_t step,
                                                                    Association items = Association::point);
    // Returns all values of a scalar on points in the dataset's type. Kept in the cache. Throws like scalar().
    [[nodiscard]] Values scalar_values(const std::string& name, std::size_t step);
    // Returns the histogram of any scalar. `range`: the range of the bins; nullopt: that of the finite values. Throws
    // like scalar(). Reads one small file if no range is given and `bins` is a power of two of at most stored_bins;
    // else all values of the step.
    [[nodiscard]] Histogram histogram(const std::string& name, std::size_t step, std::size_t bins,
                                      std::optional<std::array<double, 2>> range = std::nullopt);
    // Returns the cells whose values of the scalar's array are sound at the step, in all components; null if all cells
    // are. A value is not sound if it is a NaN or infinite result of the solver. For a point array that was
    // interpolated from cells, the values on cells count. For an array on patches, those on cells and those on its
    // faces count.
    [[nodiscard]] std::shared_ptr<const SoundCells> sound_cells(const std::string& name, std::size_t step);
    // Returns the number of cells that have a corner with a NaN or infinite result, for a scalar that the imported file
    // has on points; 0 for other scalars. Cuts leave these cells out.
    [[nodiscard]] std::size_t cells_with_bad_corners(const std::string& name, std::size_t step);
    // Returns the locator of the cells at a step, which keeps alive all that it reads.
    [[nodiscard]] std::shared_ptr<const CellLocator> locator(std::size_t step);
    // Returns the boxes around the vertices of each block of the mesh at a step. Reads one small file.
    [[nodiscard]] std::shared_ptr<const BlockBoxes> boxes(std::size_t step);
    // Returns the field dot(normal, position - origin), whose iso-surfaces are slices.
    [[nodiscard]] ScalarField plane(std::size_t step, Vec3d origin, Vec3d normal);

    [[nodiscard]] std::size_t memory_bytes() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace ciel::store
