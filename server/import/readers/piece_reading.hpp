// Reads the pieces of one mesh, one after another, for index files that name one file per piece.
#pragma once

#include "import/source/source.hpp"

namespace ciel::importer {

// Returns a partitioned data set, or a multi-block data set if a piece is not a single data set. `name`: returns the
// name of a piece; an empty function leaves the pieces unnamed. Leaves out pieces that cannot be read and adds a
// sentence for each to `lost`. Throws the first piece's Error if all are left out.
[[nodiscard]] vtkSmartPointer<vtkDataObject>
read_pieces(std::size_t count,
            const std::function<vtkSmartPointer<vtkDataObject>(std::size_t piece, const ReadProgress&)>& read,
            const std::function<std::string(std::size_t piece)>& name, std::vector<std::string>& lost,
            const ReadProgress& progress);

} // namespace ciel::importer
