// Writer: writes a dataset, NAME.ciel. A new dataset is written to a temporary directory beside its path. finish()
// renames the directory, so readers never see an incomplete dataset. Writer::append adds steps to an existing dataset.
#pragma once

#include "ciel/matched_cells.hpp"
#include "store/dataset.hpp"

namespace server::store {

struct NamedGroup {
    Group::Of of = Group::Of::faces;
    std::string name;
    std::vector<ciel::Index> ids; // ids of faces or cells of the mesh that is added
    PatchFacts facts = {};
};

struct DatasetHeader {
    std::string source, length_units;
    std::uint64_t input_vertices = 0, input_edges = 0, input_cells = 0;
    std::vector<std::string> notes;
};

// The ids are in stored order. An id of -1 means that the solver gave no id. Empty if the source has no solver ids.
struct SolverIds {
    std::span<const std::int64_t> vertex, cell;
};

struct ArrayValues {
    ArrayInfo info;          // info.doubles is ignored: a new array gets the type of its first values
    ciel::ValuesView values; // in stored order
};

class Writer {
public:
    // Throws Error when `directory` exists and `overwrite` is false, or when `directory` cannot be written.
    Writer(const std::filesystem::path& directory, const DatasetHeader& header, bool overwrite = false);
    // Locks the dataset until the Writer is destroyed. Removes temporary files of killed writers. Throws Error when the
    // dataset is locked, damaged, or a copy that `ciel serve` made for itself (imported_copy.hpp).
    [[nodiscard]] static Writer append(const std::filesystem::path& directory);
    // Like append(directory), but reads only the steps that were committed since the dataset was opened.
    [[nodiscard]] static Writer append(std::shared_ptr<Dataset> dataset);
    ~Writer(); // without finish(): deletes the temporary directory
    Writer(Writer&&) noexcept;

    // Returns the mesh's index. Throws Error as write_mesh does.
    std::size_t add_mesh(const ciel::FaceMesh& mesh, std::span<const ciel::Index> original_vertex,
                         std::span<const ciel::Index> original_cell, std::span<const NamedGroup> groups,
                         const SolverIds& solver = {});
    // Writes a mesh whose list of faces need not fit the memory. `boundary`: cells.boundary(), whose positions are not
    // used. The ids of groups of faces are those of `boundary`.
    std::size_t add_mesh(const ciel::MatchedCells& cells, const ciel::FaceMesh& boundary,
                         std::span<const ciel::Index> original_vertex, std::span<const ciel::Index> original_cell,
                         std::span<const NamedGroup> groups, const SolverIds& solver = {});
    // Returns a reference that is valid until the next call of another function. Throws Error when the mesh does not
    // exist, or when its blocks are damaged.
    [[nodiscard]] const ciel::Topology& topology(std::size_t mesh);
    // Returns the mapped offsets of all vertices from the mesh's origin. Throws Error when the mesh does not exist.
    [[nodiscard]] Values positions(std::size_t mesh, std::size_t coordinates) const;
    // Returns whether a mesh can store these positions without rounding. A mesh stores floats if its first positions
    // were floats, else doubles.
    [[nodiscard]] bool holds(std::size_t mesh, ciel::ValuesView positions) const;
    // `positions`: offsets of all vertices from the mesh's origin. Returns the index of the set. Throws Error when
    // their number is wrong, when a position is not finite, or when the mesh cannot store them without rounding.
    std::size_t add_coordinates(std::size_t mesh, ciel::ValuesView positions);
    // Returns the index of the last coordinate set that is bitwise equal to `positions`; nullopt if there is none.
    [[nodiscard]] std::optional<std::size_t> find_coordinates(std::size_t mesh, ciel::ValuesView positions) const;
    // When appending, readers see the step as soon as the call returns. The values are converted to the type of earlier
    // steps. Throws Error when an array has a wrong size, or when `time` is not later than the last step.
    void add_step(double time, std::size_t mesh, std::size_t coordinates, std::span<const ArrayValues> arrays);
    // Add a step array by array, so that only one array must be in memory. Call begin_step, then add_values for each
    // array, then end_step. If add_values or end_step throws, the whole step is dropped.
    void begin_step(double time, std::size_t mesh, std::size_t coordinates);
    void add_values(const ArrayValues& array);
    void end_step();
    // Adds a step whose arrays are late (late_writer.hpp). ArrayInfo::doubles sets the type of a new array.
    void add_late_step(double time, std::size_t mesh, std::size_t coordinates, std::span<const ArrayInfo> arrays);
    void set_late(LateSource source); // the source from which late arrays are read
    void add_note(const std::string& sentence);

    // Returns the dataset as it was when append() locked it; null for a new dataset.
    [[nodiscard]] const std::shared_ptr<Dataset>& before() const;

    void finish(); // checks that a new dataset can be opened, then renames it to its path

private:
    struct State;
    explicit Writer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace server::store
