// The pieces of one mesh, read one after the other, for sources that name a file for each.
#pragma once

#include "import/source/source.hpp"

namespace ciel::importer {

// A partitioned data set, whose pieces have names where `name` is given. A piece that cannot be read costs that piece:
// a sentence goes to `lost`. Throws Error, that of the first, where none can be read.
[[nodiscard]] vtkSmartPointer<vtkDataObject>
read_pieces(std::size_t count,
            const std::function<vtkSmartPointer<vtkDataObject>(std::size_t piece, const ReadProgress&)>& read,
            const std::function<std::string(std::size_t piece)>& name, std::vector<std::string>& lost,
            const ReadProgress& progress);

} // namespace ciel::importer
