// Writes NAME.ciel: everything goes to a temporary sibling directory that is renamed by finish(); nothing half-written
// is ever seen. Used by import and by the demo; `append` adds committed steps to an existing dataset.
#pragma once

#include "ciel/assemble.hpp"
#include "store/dataset.hpp"

namespace ciel::store {

struct NamedGroup {
    Group::Of of = Group::Of::faces;
    std::string name;
    std::vector<Index> ids; // stored ids
    PatchFacts facts = {};
};

struct DatasetHeader {
    std::string source, length_units;
    std::uint64_t input_vertices = 0, input_edges = 0, input_cells = 0;
    std::vector<std::string> notes;
};

// The numbers that the solver gave to vertices and cells, in stored order, -1 where it gave none; or empty.
struct SolverIds {
    std::span<const std::int64_t> vertex, cell;
};

struct ArrayValues {
    ArrayInfo info;
    std::span<const float> values; // in stored order
};

class Writer {
public:
    // Throws Error when `directory` exists and `overwrite` is false, or cannot be written.
    Writer(const std::filesystem::path& directory, const DatasetHeader& header, bool overwrite = false);
    // Opens an existing dataset to append steps to it, under a lock that ends with the Writer. Removes what killed
    // writers have left aside. Throws Error when another writer has the lock, when the dataset is damaged, or when it
    // is a copy that `ciel serve` made for itself (imported_copy.hpp).
    [[nodiscard]] static Writer append(const std::filesystem::path& directory);
    // The same of one that is open already: only the steps committed since are read.
    [[nodiscard]] static Writer append(std::shared_ptr<Dataset> dataset);
    ~Writer(); // without finish(): removes what was written aside
    Writer(Writer&&) noexcept;

    // Counts edges, components and bounds for `info`, checksums everything. Returns the mesh's index.
    std::size_t add_mesh(const FaceMesh& mesh, std::span<const Index> original_vertex,
                         std::span<const Index> original_cell, std::span<const NamedGroup> groups,
                         const SolverIds& solver = {});
    // New positions of an existing mesh (offsets from its origin). Returns the coordinates' index.
    std::size_t add_coordinates(std::size_t mesh, std::span<const float> positions);
    // The coordinates of the mesh that are the same to the bit, the latest where there are several.
    [[nodiscard]] std::optional<std::size_t> find_coordinates(std::size_t mesh, std::span<const float> positions) const;
    // In append mode each step is committed (visible to readers) when this returns. Throws Error on a wrong size, or
    // when `time` is not later than the last step's.
    void add_step(double time, std::size_t mesh, std::size_t coordinates, std::span<const ArrayValues> arrays);
    // The same array by array, so that only one needs to be in memory: begin, add each, end. What fails on the way
    // takes back the whole step.
    void begin_step(double time, std::size_t mesh, std::size_t coordinates);
    void add_values(const ArrayValues& array);
    void end_step();
    void add_note(const std::string& sentence);

    // Of append(): the dataset as it was when it was locked.
    [[nodiscard]] const std::shared_ptr<Dataset>& before() const;

    void finish(); // verifies, renames

private:
    struct State;
    explicit Writer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace ciel::store
