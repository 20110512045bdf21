// Reads the pieces of one mesh, one after another. For index files that list one file per piece.
#pragma once

#include "import/source/source.hpp"

namespace ciel::importer {

// Returns a partitioned data set, or a multi-block data set if a piece is not a single data set. `read`: reads a piece.
// `name`: returns the name of a piece; if `name` is empty, the pieces have no names. Leaves out each piece that cannot
// be read and adds a sentence to `lost`. If all pieces are left out, throws the Error of the first piece.
[[nodiscard]] vtkSmartPointer<vtkDataObject>
read_pieces(std::size_t count,
            const std::function<vtkSmartPointer<vtkDataObject>(std::size_t piece, const ReadProgress&)>& read,
            const std::function<std::string(std::size_t piece)>& name, std::vector<std::string>& lost,
            const ReadProgress& progress);

} // namespace ciel::importer
