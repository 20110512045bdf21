// The element sets of an Exodus II file, by the library that VTK's reader uses too.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>
#include <vtkMultiBlockDataSet.h>
#include <vtkUnstructuredGrid.h>

namespace ciel::importer {

using ElementSet = std::vector<std::pair<unsigned, vtkIdType>>; // (place of the block in `block_ids`, cell in it)

// In the order of `set_ids`. Throws Error when the file cannot be read or a set names an element it does not have.
[[nodiscard]] std::vector<ElementSet> read_element_sets(const std::string& file,
                                                        const std::vector<std::int64_t>& block_ids,
                                                        const std::vector<std::int64_t>& set_ids);

// The corners of each cell of the set, as point sets: enough to find the cells again.
[[nodiscard]] vtkSmartPointer<vtkUnstructuredGrid> copy_cells(vtkMultiBlockDataSet* data_sets, const ElementSet& set);

} // namespace ciel::importer
