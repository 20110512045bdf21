// Benchmarks of one dataset and one point scalar: four tables of the paper, frames, and pictures of a volume.
#pragma once

#include "bench/table.hpp"
#include "ciel/extract.hpp"
#include "store/loaded.hpp"

namespace ciel::bench {

// Input of all tables: the last step in which the array varies. The step before with the array, if it has the same
// mesh, is the changed field.
struct Case {
    std::shared_ptr<store::Dataset> dataset;
    std::shared_ptr<store::LoadedDataset> loaded; // the same, as the server holds it
    std::string path;                             // to open it again
    std::string array;
    double time = 0;
    FaceMeshView mesh;
    std::shared_ptr<const std::vector<float>> values;
    std::shared_ptr<const std::vector<float>> changed; // of that step, else `values` times 1.01
    std::shared_ptr<const Topology> topology;
};

// Opens the dataset at `path`. An empty `array` selects the first point array that varies.
// Throws Error when the dataset has no such scalar or when the scalar does not vary.
[[nodiscard]] Case open_case(const std::string& path, const std::string& array);

[[nodiscard]] Table memory_table(const Case& data);        // the paper's table 2
[[nodiscard]] Table preprocessing_table(const Case& data); // table 3: loading, construction, gradients, minima
[[nodiscard]] Table slices_table(const Case& data);        // table 4: slices for volume rendering
[[nodiscard]] Table surfaces_table(const Case& data);      // table 5
// These two draw with the GL that is available.
[[nodiscard]] Table frames_table(const Case& data); // from a change of the scene to an encoded picture
[[nodiscard]] Table volume_table(const Case& data); // pictures of a volume

[[nodiscard]] std::uint64_t triangles_of(const Surface& surface);
// Returns `count` equally spaced values inside the range, without its ends.
[[nodiscard]] std::vector<double> values_between(double low, double high, std::size_t count);
[[nodiscard]] Field field_of(const Case& data, std::shared_ptr<const std::vector<float>> values);

} // namespace ciel::bench
