// Reads the pieces of one mesh, one after another. For index files that list one file per piece.
#pragma once

#include "import/source/source.hpp"

namespace server::importer {

// `name`: returns the name of a piece; may be null. Leaves out each piece that cannot be read and adds a sentence to
// `lost`. If all pieces are left out, throws the Error of the first piece.
[[nodiscard]] vtkSmartPointer<vtkDataObject>
read_pieces(std::size_t count,
            const std::function<vtkSmartPointer<vtkDataObject>(std::size_t piece, const ReadProgress&)>& read,
            const std::function<std::string(std::size_t piece)>& name, std::vector<std::string>& lost,
            const ReadProgress& progress);

} // namespace server::importer
