// LoadedDataset: a dataset in memory, shared by all sessions. Keeps one Topology per mesh and a cache of Fields.
#pragma once

#include "ciel/cell_locator.hpp"
#include "store/scalar_field.hpp"
#include "store/stored_scalar.hpp"

namespace server::store {

// Records which cells have a NaN or infinite result of the solver in an array. Pictures do not show these cells.
struct SoundCells {
    std::vector<std::uint8_t> kept; // a flag per cell; 0: the cell has a NaN or infinite result
    std::size_t left_out = 0;       // number of cells whose flag is 0
};

// Error: the array was not written at the requested step. The dataset is not damaged.
class NotWritten : public ciel::Error {
    using ciel::Error::Error;
};

// Answer to a request for the late arrays (late_files.hpp) of a step.
struct LateAnswer {
    std::string words;       // state of the arrays, such as "is being read from its source"
    bool has_failed = false; // the arrays cannot be read
};
// Requests that the late arrays of a step are read, and returns at once. Called from any thread.
using AskForStep = std::function<LateAnswer(const Dataset& dataset, std::size_t step)>;

// Error: the array is late, that is, not read from its source yet. has_failed: reading failed; do not ask again soon.
class NotYetRead : public NotWritten {
public:
    NotYetRead(const std::string& sentence, bool has_failed_) : NotWritten(sentence), has_failed(has_failed_) {}
    bool has_failed;
};

// Thread-safe. Three quarters of `field_budget_bytes` are for a least-recently-used cache of fields. One quarter is for
// the field of the last plane. In addition, the fits of gradients (CellFits) may use another quarter.
class LoadedDataset {
public:
    // `ask`: called before NotYetRead is thrown; may be empty.
    LoadedDataset(std::shared_ptr<Dataset> dataset, std::size_t field_budget_bytes, AskForStep ask = {});
    ~LoadedDataset();

    [[nodiscard]] std::shared_ptr<Dataset> dataset() const; // the dataset as of the last refresh()
    bool refresh(); // adds new steps from the disk; returns whether there were any

    // This and the functions below throw Error when a file is damaged or cannot be read.
    [[nodiscard]] std::shared_ptr<const ciel::Topology> topology(std::size_t mesh);
    // Throws NotWritten when the array was not written at the step, NotYetRead when it is late, and Error when `name`
    // is not a scalar on points.
    [[nodiscard]] ScalarField scalar(const std::string& name, std::size_t step);
    // Throws NotYetRead if an array of the step is late.
    void require_read(std::size_t step) const;
    // The values are read when they are needed. Throws like scalar(), and Error when the scalar is not on `items`.
    [[nodiscard]] std::shared_ptr<const StoredScalar> stored_scalar(const std::string& name, std::size_t step,
                                                                    Association items = Association::point);
    // The values are cached, or those of the mapped file (StoredScalar::all). Throws like scalar().
    [[nodiscard]] Values scalar_values(const std::string& name, std::size_t step);
    // Returns the histogram of any scalar. `range`: the range of the bins; nullopt: the range of the finite values.
    // Throws like scalar(). If no range is given and `bins` is a power of two of at most stored_bins, reads one small
    // file. Otherwise reads all values of the step and calls `values_read`.
    [[nodiscard]] Histogram histogram(const std::string& name, std::size_t step, std::size_t bins,
                                      std::optional<std::array<double, 2>> range = std::nullopt,
                                      const ValuesRead& values_read = {});
    // Returns null if all cells are sound. A cell is not sound if one of its values, in any component, is a NaN or
    // infinite result of the solver. For an interpolated point array, these are the values of the cell array. For an
    // array on patches, these are the values on the cells and on the patch faces.
    [[nodiscard]] std::shared_ptr<const SoundCells> sound_cells(const std::string& name, std::size_t step);
    // Returns the number of cells that have a NaN or infinite result at a corner. Surfaces and slices leave these cells
    // out. Only for a scalar that the imported file has on points; returns 0 for other scalars.
    [[nodiscard]] std::size_t cells_with_bad_corners(const std::string& name, std::size_t step);
    // The locator keeps all data alive that it reads.
    [[nodiscard]] std::shared_ptr<const ciel::CellLocator> locator(std::size_t step);
    // Returns, for each block, the bounding box of its vertices. Reads one small file, or all positions if no boxes are
    // stored.
    [[nodiscard]] std::shared_ptr<const ciel::BlockBoxes> boxes(std::size_t step);
    // Returns the field dot(normal, position - origin), whose iso-surfaces are slices. `origin`: in world coordinates.
    // `normal` has unit length.
    [[nodiscard]] ScalarField plane(std::size_t step, ciel::Vec3d origin, ciel::Vec3d normal);

    // The next three functions return positions as offsets from `origin`. `kept`: one flag per cell; if it is empty,
    // all cells are kept. Returns the numbered faces (mesh_arrays.hpp) `numbers` whose owner is kept, each once.
    // polygon_face: the number of the face.
    [[nodiscard]] ciel::Surface surface_of_faces(std::size_t step, std::vector<ciel::Index> numbers,
                                                 std::span<const std::uint8_t> kept, const ciel::Vec3d& origin);
    // Returns the boundary of the kept cells. polygon_face: the number of the face, or `none` for an inner face that
    // has no number.
    [[nodiscard]] ciel::Surface boundary_surface(std::size_t step, std::span<const std::uint8_t> kept,
                                                 const ciel::Vec3d& origin);
    // Returns the vertices of the kept cells, as a surface without polygons.
    [[nodiscard]] ciel::Surface vertices_of_cells(std::size_t step, std::span<const std::uint8_t> kept,
                                                  const ciel::Vec3d& origin);

    [[nodiscard]] std::size_t memory_bytes() const;
    void drop_unused_fields(); // frees cached fields and values that no caller holds, except the last used ones

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace server::store
