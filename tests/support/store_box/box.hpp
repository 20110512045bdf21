// A box of unit hexahedra as a FaceMesh and as a dataset, for the store's tests.
#pragma once

#include "ciel/face_mesh.hpp"
#include "store/writer.hpp"
#include "support/folder.hpp"

#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

namespace ciel::test {

// nx x ny x nz hexahedra at integer positions. Cells and vertices are numbered with x fastest.
FaceMesh box(Index nx, Index ny, Index nz);
std::vector<Index> identity(std::size_t count);

// Writes a dataset with one mesh, the groups "wall" (faces) and "inner/zone" (cells), and arrays at the times 0, 0.5
// and 1.0. The arrays are p (point), U (point, 3 components) and "cell:p" (cell); p is missing at 0.5. p = vertex id +
// 1000 * step.
void write_box(const std::filesystem::path& directory, const FaceMesh& mesh);
std::vector<float> values_of(std::size_t count, std::size_t step);

std::string read_file(const std::filesystem::path& file);
std::string hex_dump(const std::string& bytes); // lines of 16 bytes, as the store's README shows them
void overwrite_file(const std::filesystem::path& file, const std::string& content);

} // namespace ciel::test
