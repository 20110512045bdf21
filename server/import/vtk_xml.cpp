// VTK's XML files: the reader follows from the type in the first element, whatever the extension says.
#include "ciel/types.hpp"
#include "import/formats.hpp"
#include "import/reader_source.hpp"

#include <fstream>
#include <regex>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPImageDataReader.h>
#include <vtkXMLPRectilinearGridReader.h>
#include <vtkXMLPStructuredGridReader.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLPartitionedDataSetCollectionReader.h>
#include <vtkXMLPartitionedDataSetReader.h>
#include <vtkXMLRectilinearGridReader.h>
#include <vtkXMLStructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace ciel::importer {

namespace {

template <typename Reader>
vtkSmartPointer<vtkXMLReader> make() {
    return vtkSmartPointer<Reader>::New();
}

struct XmlType {
    std::string_view type;
    bool composite; // names the files that hold the data: its own arrays are none
    vtkSmartPointer<vtkXMLReader> (*make)();
};
constexpr XmlType xml_types[] = {
    {"UnstructuredGrid", false, make<vtkXMLUnstructuredGridReader>},
    {"PUnstructuredGrid", false, make<vtkXMLPUnstructuredGridReader>},
    {"StructuredGrid", false, make<vtkXMLStructuredGridReader>},
    {"PStructuredGrid", false, make<vtkXMLPStructuredGridReader>},
    {"RectilinearGrid", false, make<vtkXMLRectilinearGridReader>},
    {"PRectilinearGrid", false, make<vtkXMLPRectilinearGridReader>},
    {"ImageData", false, make<vtkXMLImageDataReader>},
    {"PImageData", false, make<vtkXMLPImageDataReader>},
    {"vtkMultiBlockDataSet", true, make<vtkXMLMultiBlockDataReader>},
    {"vtkPartitionedDataSet", true, make<vtkXMLPartitionedDataSetReader>},
    {"vtkPartitionedDataSetCollection", true, make<vtkXMLPartitionedDataSetCollectionReader>},
};

std::string type_in(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string head(4096, '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    static const std::regex element(R"(<VTKFile[^>]*\btype\s*=\s*["'](\w+)["'])");
    std::smatch match;
    return std::regex_search(head, match, element) ? match[1].str() : "";
}

} // namespace

std::unique_ptr<Source> open_vtk_xml(const Inputs& inputs, const SourceOptions&) {
    const std::string& file = inputs.front();
    const std::string type = type_in(file);
    for (const XmlType& row : xml_types) {
        if (row.type != type) continue;
        const vtkSmartPointer<vtkXMLReader> reader = row.make();
        reader->SetFileName(file.c_str());
        ReaderSource::ListArrays list_arrays;
        if (!row.composite) list_arrays = [&reader] { return arrays_of(*reader); };
        return std::make_unique<ReaderSource>("VTK XML " + type, file, reader, list_arrays);
    }
    throw Error(file + ": is a VTK XML file of type \"" + type + "\", which holds no volume mesh");
}

} // namespace ciel::importer
