// The paper's four tables, frames and the pictures of a volume, each for one dataset and one scalar on its points.
#pragma once

#include "bench/table.hpp"
#include "ciel/extract.hpp"
#include "store/loaded.hpp"

namespace ciel::bench {

// What all tables measure. The dataset's last step with the array is used; where the array has one more, its values are
// the changed field.
struct Case {
    std::shared_ptr<store::Dataset> dataset;
    std::shared_ptr<store::LoadedDataset> loaded; // the same, as the server holds it
    std::string path;                             // to open it again
    std::string array;
    double time = 0;
    FaceMeshView mesh;
    std::shared_ptr<const std::vector<float>> values;
    std::shared_ptr<const std::vector<float>> changed; // of another step on the same mesh, else the field times 1.01
    std::shared_ptr<const Topology> topology;
};

// Throws Error where the dataset has no such scalar; the first one that varies without a name.
[[nodiscard]] Case open_case(const std::string& path, const std::string& array);

[[nodiscard]] Table memory_table(const Case& data);        // the paper's table 2
[[nodiscard]] Table preprocessing_table(const Case& data); // 3: loading, construction, gradients, minima
[[nodiscard]] Table slices_table(const Case& data);        // 4: what volume rendering draws
[[nodiscard]] Table surfaces_table(const Case& data);      // 5
// With the GL that is there:
[[nodiscard]] Table frames_table(const Case& data); // from a change of the scene to an encoded picture
[[nodiscard]] Table volume_table(const Case& data); // pictures of a volume

[[nodiscard]] std::uint64_t triangles_of(const Surface& surface);
// Equally spaced inside the range, without its ends.
[[nodiscard]] std::vector<double> values_between(double low, double high, std::size_t count);
[[nodiscard]] Field field_of(const Case& data, std::shared_ptr<const std::vector<float>> values);

} // namespace ciel::bench
