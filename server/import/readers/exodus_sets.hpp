// Reads the element sets of an Exodus II file with the library that VTK's reader also uses.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>
#include <vtkMultiBlockDataSet.h>
#include <vtkUnstructuredGrid.h>

namespace server::importer {

// For each element of the set: the index of its element block in `block_ids`, and its cell id in this element block.
using ElementSet = std::vector<std::pair<unsigned, vtkIdType>>;

// Returns the sets in the order of `set_ids`. Leaves out elements of element blocks that are not in `block_ids`. Throws
// Error if the file cannot be read, or if a set contains an element that the file does not have.
[[nodiscard]] std::vector<ElementSet> read_element_sets(const std::string& file,
                                                        const std::vector<std::int64_t>& block_ids,
                                                        const std::vector<std::int64_t>& set_ids);

// Returns the cells of the set as convex point sets. Their points are enough to find the cells in the mesh
// (mesh/zones.hpp).
[[nodiscard]] vtkSmartPointer<vtkUnstructuredGrid> copy_cells(vtkMultiBlockDataSet* blocks, const ElementSet& set);

} // namespace server::importer
