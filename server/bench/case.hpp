// Benchmarks of one point scalar of a dataset: four tables of the paper, frames, and pictures of a volume.
#pragma once

#include "bench/table.hpp"
#include "ciel/extract.hpp"
#include "store/loaded.hpp"

namespace ciel::bench {

// Input of all tables: a scalar of a dataset at the last step at which its array varies.
struct Case {
    std::shared_ptr<store::Dataset> dataset;
    std::shared_ptr<store::LoadedDataset> loaded; // the same dataset, as the server holds it in memory
    std::string path;                             // of the dataset, for the benchmark that opens it again
    std::string array;
    double time = 0;
    FaceMeshView mesh;
    store::Values values;
    // The scalar at the previous step at which the array varies, if that step has the same mesh; else `values` times
    // 1.01.
    store::Values changed;
    std::shared_ptr<const Topology> topology;
    std::shared_ptr<CellFits> cell_fits; // shared by the fields of field_of
};

// Opens the dataset at `path`. An empty `array` selects the first point array that varies. Throws Error when the
// dataset has no scalar of that name, or when the scalar has the same value everywhere.
[[nodiscard]] Case open_case(const std::string& path, const std::string& array);

[[nodiscard]] Table memory_table(const Case& data);        // the paper's table 2
[[nodiscard]] Table preprocessing_table(const Case& data); // the paper's table 3: loading, construction, minima
[[nodiscard]] Table slices_table(const Case& data);        // the paper's table 4: slices for volume rendering
[[nodiscard]] Table surfaces_table(const Case& data);      // the paper's table 5
// frames_table and volume_table draw with the OpenGL that is available.
[[nodiscard]] Table frames_table(const Case& data); // from a change of the scene to an encoded picture
[[nodiscard]] Table volume_table(const Case& data); // pictures of a volume

[[nodiscard]] std::uint64_t triangles_of(const Surface& surface);
// Returns `count` equally spaced values between `low` and `high`; neither end is included.
[[nodiscard]] std::vector<double> values_between(double low, double high, std::size_t count);
[[nodiscard]] Field field_of(const Case& data, const store::Values& values);

} // namespace ciel::bench
