// LS-DYNA databases: d3plot and its family, or the XML file that names them.
#include "import/formats.hpp"
#include "import/reader_source.hpp"

#include <vtkLSDynaReader.h>
#include <vtkNew.h>

namespace ciel::importer {

std::unique_ptr<Source> open_lsdyna(const Inputs& inputs, const SourceOptions&) {
    vtkNew<vtkLSDynaReader> reader;
    reader->SetFileName(inputs.front().c_str());
    reader->SetDeformedMesh(1); // the current positions: a moving mesh
    reader->UpdateInformation();
    for (int i = 0; i < reader->GetNumberOfPointArrays(); ++i) reader->SetPointArrayStatus(i, 1);
    for (int i = 0; i < reader->GetNumberOfSolidArrays(); ++i) reader->SetSolidArrayStatus(i, 1);
    return std::make_unique<ReaderSource>("LS-DYNA", inputs.front(), reader.Get());
}

} // namespace ciel::importer
