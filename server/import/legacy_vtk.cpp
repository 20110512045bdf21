// Legacy VTK files of any data set type; what they declare is held against their size first.
#include "import/formats.hpp"
#include "import/parsers/legacy_vtk_counts.hpp"
#include "import/reader_source.hpp"

#include <fstream>
#include <vtkGenericDataObjectReader.h>
#include <vtkNew.h>

namespace ciel::importer {

std::unique_ptr<Source> open_legacy_vtk(const Inputs& inputs, const SourceOptions&) {
    const std::string& file = inputs.front();
    std::ifstream stream(file, std::ios::binary);
    check_legacy_vtk_counts(stream, std::filesystem::file_size(file), file);
    vtkNew<vtkGenericDataObjectReader> reader;
    reader->SetFileName(file.c_str());
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllNormalsOn();
    reader->ReadAllTensorsOn();
    reader->ReadAllFieldsOn();
    return std::make_unique<ReaderSource>("legacy VTK", file, reader.Get());
}

} // namespace ciel::importer
