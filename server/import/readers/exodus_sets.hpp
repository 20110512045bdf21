// Reads the element sets of an Exodus II file with the library that VTK's reader also uses.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>
#include <vtkMultiBlockDataSet.h>
#include <vtkUnstructuredGrid.h>

namespace ciel::importer {

// Per element: the index of its block in `block_ids`, and its cell id in that block.
using ElementSet = std::vector<std::pair<unsigned, vtkIdType>>;

// Returns the sets in the order of `set_ids`, without elements of blocks that are not in `block_ids`. Throws Error when
// the file cannot be read or a set names an element that the file does not have.
[[nodiscard]] std::vector<ElementSet> read_element_sets(const std::string& file,
                                                        const std::vector<std::int64_t>& block_ids,
                                                        const std::vector<std::int64_t>& set_ids);

// Copies the cells of the set as convex point sets. Their points are enough to match them to mesh cells
// (mesh/zones.hpp).
[[nodiscard]] vtkSmartPointer<vtkUnstructuredGrid> copy_cells(vtkMultiBlockDataSet* data_sets, const ElementSet& set);

} // namespace ciel::importer
