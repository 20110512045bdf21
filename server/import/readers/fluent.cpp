// Fluent: a legacy .cas file with a .dat file, or an HDF5 .cas.h5 file ("CFF") with a .dat.h5 file.
#include "ciel/types.hpp"
#include "import/readers/formats.hpp"
#include "import/readers/reader_source.hpp"
#include "import/readers/regular_file.hpp"

#include <vtkFLUENTReader.h>
#include <vtkNew.h>
#include <vtkVersion.h>
#ifdef CIEL_FLUENT_CFF
#include <vtkFLUENTCFFReader.h>
#endif

namespace server::importer {

bool is_fluent(const Head& head) { return head.extension == ".cas" && head.bytes.find('(') != std::string::npos; }

bool is_fluent_cff(const Head& head) {
    return head.bytes.starts_with("\x89HDF\r\n\x1a\n") && head.extension == ".h5" &&
           head.path.stem().extension() == ".cas";
}

std::unique_ptr<Source> open_fluent(const Inputs& inputs, const SourceOptions&) {
    require_regular(std::filesystem::path(inputs.front()).replace_extension(".dat"));
    vtkNew<vtkFLUENTReader> reader;
    reader->SetFileName(inputs.front().c_str());
    return std::make_unique<ReaderSource>("Fluent", inputs.front(), reader.Get());
}

std::unique_ptr<Source> open_fluent_cff(const Inputs& inputs, const SourceOptions&) {
#ifdef CIEL_FLUENT_CFF
    vtkNew<vtkFLUENTCFFReader> reader;
    reader->SetFileName(inputs.front());
    return std::make_unique<ReaderSource>("Fluent CFF", inputs.front(), reader.Get());
#else
    throw ciel::Error(
        inputs.front() + ": VTK " + vtkVersion::GetVTKVersion() +
        " does not read Fluent's HDF5 files; import the file with CIEL's container image, which has a newer "
        "VTK, or write legacy .cas and .dat files in Fluent");
#endif
}

} // namespace server::importer
