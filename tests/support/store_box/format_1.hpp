// Datasets as earlier versions of CIEL wrote them.
#pragma once

#include "ciel/face_mesh.hpp"

#include <filesystem>

namespace ciel::test {

// Stores mesh 0 of a dataset as format 1 did: with all its faces, groups of their ids, and no numbered faces. `mesh`:
// as it was written. The blocks stay, as the later versions of format 1 had them.
void make_format_1(const std::filesystem::path& dataset, const FaceMesh& mesh);

// Removes the blocks and the ranges, as the first version of format 1 had none.
void remove_blocks(const std::filesystem::path& dataset);

} // namespace ciel::test
