// VTK's XML files. The type in the first element selects the reader; the extension does not matter.
#include "ciel/types.hpp"
#include "import/readers/formats.hpp"
#include "import/readers/piece_reading.hpp"
#include "import/readers/reader_source.hpp"
#include "import/readers/regular_file.hpp"

#include <filesystem>
#include <fstream>
#include <pugixml.hpp>
#include <regex>
#include <unordered_set>
#include <utility>
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

namespace server::importer {

namespace {

template <typename Reader>
vtkSmartPointer<vtkXMLReader> make() {
    return vtkSmartPointer<Reader>::New();
}

struct XmlType {
    std::string_view type;
    bool composite; // true: an index of other files, whose reader lists no arrays
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

class References {
public:
    explicit References(const std::filesystem::path& file) { add(file, 0); }
    [[nodiscard]] std::vector<std::filesystem::path> take() { return std::move(files_); }

private:
    // Also adds the files that an index names. Opens each file only once, because indexes may form cycles.
    void add(const std::filesystem::path& file, int depth) {
        constexpr std::uintmax_t most_bytes = 256U << 20;
        constexpr int deepest = 8;
        if (!seen_.insert(file.lexically_normal().string()).second) return;
        files_.push_back(file);
        std::error_code missing;
        if (depth > deepest || !std::filesystem::is_regular_file(file, missing)) return;
        const std::string type = type_in(file.string());
        const bool is_index = type.starts_with("P") || type.starts_with("vtk");
        if (!is_index || std::filesystem::file_size(file, missing) > most_bytes || missing) return;
        pugi::xml_document document;
        if (!document.load_file(file.c_str())) return; // VTK's reader reports malformed XML
        for (const auto& found : document.select_nodes("//@Source | //@file"))
            add(file.parent_path() / found.attribute().value(), depth + 1);
    }

    std::vector<std::filesystem::path> files_;
    std::unordered_set<std::string> seen_;
};

// Keeps pieces apart, so that the import can join them along their cuts. VTK's reader would append them to one grid.
class PiecesSource : public ReaderSource {
public:
    PiecesSource(const std::string& file, const vtkSmartPointer<vtkXMLReader>& whole, std::vector<std::string> pieces)
        : ReaderSource("VTK XML PUnstructuredGrid", file, whole, [&] { return arrays_of(*whole); }),
          pieces_(std::move(pieces)) {}

    [[nodiscard]] vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) override {
        lost_.clear();
        // Pieces with several steps are rare. VTK's reader reads them.
        if (times().size() > 1) return ReaderSource::read(step, progress);
        const auto read_piece = [&](std::size_t i, const ReadProgress& of_piece) {
            return open_vtk_xml({pieces_[i]}, {})->read(0, of_piece);
        };
        return read_pieces(pieces_.size(), read_piece, nullptr, lost_, progress);
    }
    [[nodiscard]] std::vector<std::string> lost() const override { return lost_; }

private:
    std::vector<std::string> pieces_;
    std::vector<std::string> lost_;
};

std::vector<std::string> pieces_in(const std::string& file) {
    pugi::xml_document document;
    std::vector<std::string> pieces;
    if (!document.load_file(file.c_str())) return pieces;
    for (const auto& found : document.select_nodes("//Piece/@Source"))
        pieces.push_back((std::filesystem::path(file).parent_path() / found.attribute().value()).string());
    return pieces;
}

} // namespace

std::vector<std::filesystem::path> files_of_vtk_xml(const std::filesystem::path& file) {
    return References(file).take();
}

std::unique_ptr<Source> open_vtk_xml(const Inputs& inputs, const SourceOptions&) {
    const std::string& file = inputs.front();
    const std::string type = type_in(file);
    for (const std::filesystem::path& named : files_of_vtk_xml(file)) require_regular(named);
    for (const XmlType& row : xml_types) {
        if (row.type != type) continue;
        const vtkSmartPointer<vtkXMLReader> reader = row.make();
        reader->SetFileName(file.c_str());
        if (type == "PUnstructuredGrid")
            if (auto pieces = pieces_in(file); pieces.size() > 1)
                return std::make_unique<PiecesSource>(file, reader, std::move(pieces));
        ReaderSource::ListArrays list_arrays;
        if (!row.composite) list_arrays = [&reader] { return arrays_of(*reader); };
        return std::make_unique<ReaderSource>("VTK XML " + type, file, reader, list_arrays);
    }
    throw ciel::Error(file + ": is a VTK XML file of type \"" + type +
                      "\", which holds no volume mesh; give a file of volume cells, such as a VTU");
}

} // namespace server::importer
