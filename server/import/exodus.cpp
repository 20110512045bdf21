// Exodus II: element blocks with their nodes, side sets as patches.
#include "import/formats.hpp"
#include "import/reader_source.hpp"

#include <vtkExodusIIReader.h>
#include <vtkNew.h>

namespace ciel::importer {

std::unique_ptr<Source> open_exodus(const Inputs& inputs, const SourceOptions&) {
    vtkNew<vtkExodusIIReader> reader;
    reader->SetFileName(inputs.front().c_str());
    reader->SetApplyDisplacements(0); // positions as the file has them; the displacement stays an array
    reader->GenerateGlobalNodeIdArrayOn();
    reader->UpdateInformation();
    for (const int type : {vtkExodusIIReader::ELEM_BLOCK, vtkExodusIIReader::SIDE_SET, vtkExodusIIReader::NODAL}) {
        for (int i = 0; i < reader->GetNumberOfObjects(type); ++i) reader->SetObjectStatus(type, i, 1);
        for (int i = 0; i < reader->GetNumberOfObjectArrays(type); ++i)
            reader->SetObjectArrayStatus(type, reader->GetObjectArrayName(type, i), 1);
    }
    return std::make_unique<ReaderSource>("Exodus II", inputs.front(), reader.Get());
}

} // namespace ciel::importer
