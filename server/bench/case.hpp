// Benchmarks of one point scalar of a dataset.
#pragma once

#include "bench/table.hpp"
#include "ciel/extract.hpp"
#include "store/loaded.hpp"

namespace server::bench {

// Input of all tables: a scalar of a dataset, at the last step at which the values of its array are not all equal.
struct Case {
    std::shared_ptr<store::Dataset> dataset;
    std::shared_ptr<store::LoadedDataset> loaded; // the same dataset, as the server holds it in memory
    std::string path;                             // path of the dataset, for the benchmark that opens it again
    std::string array;
    double time = 0;
    ciel::FaceMeshView mesh;
    store::Values values;
    // The scalar at the previous step at which the values of its array are not all equal, if that step has the same
    // mesh. Otherwise `values` times 1.01.
    store::Values changed;
    std::shared_ptr<const ciel::Topology> topology;
    std::shared_ptr<ciel::CellFits> cell_fits; // gradient fits that the fields of field_of share
};

// If `array` is empty, selects the first point array that varies. Throws Error when the scalar is missing or constant.
[[nodiscard]] Case open_case(const std::string& path, const std::string& array);

[[nodiscard]] Table memory_table(const Case& data);        // the paper's table 2
[[nodiscard]] Table preprocessing_table(const Case& data); // the paper's table 3: opening, construction, minima
[[nodiscard]] Table slices_table(const Case& data);        // the paper's table 4: slices for volume rendering
[[nodiscard]] Table surfaces_table(const Case& data);      // the paper's table 5
// frames_table and volume_table draw with the available OpenGL, on a GPU or in software.
[[nodiscard]] Table frames_table(const Case& data); // from a change of the scene to an encoded picture
[[nodiscard]] Table volume_table(const Case& data); // pictures of a volume

[[nodiscard]] std::uint64_t triangles_of(const ciel::Surface& surface);
// Returns `count` equally spaced values between `low` and `high`; neither end is included.
[[nodiscard]] std::vector<double> values_between(double low, double high, std::size_t count);
[[nodiscard]] ciel::Field field_of(const Case& data, const store::Values& values);

} // namespace server::bench
