// Datasets as earlier versions of CIEL wrote them.
#pragma once

#include "ciel/face_mesh.hpp"

#include <filesystem>

namespace ciel::test {

// Stores mesh 0 of a dataset as format 1 did: with all its faces, groups of their ids, and no numbered faces. `mesh`:
// the mesh that was written. The blocks stay, because later versions of format 1 had them.
void make_format_1(const std::filesystem::path& dataset, const FaceMesh& mesh);

// Removes the blocks and the ranges, which the first version of format 1 did not have.
void remove_blocks(const std::filesystem::path& dataset);

} // namespace ciel::test
