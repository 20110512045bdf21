// OpenFOAM cases: a directory, its controlDict, or the empty .foam file beside them. Polyhedra stay polyhedra, cell
// data stays cell data, every patch comes with its own values, and zones are named.
#include "import/formats.hpp"
#include "import/parsers/openfoam_units.hpp"
#include "import/reader_source.hpp"

#include <cstdlib>
#include <fstream>
#include <vtkDummyController.h>
#include <vtkNew.h>
#include <vtkPOpenFOAMReader.h>

namespace ciel::importer {

namespace {

namespace fs = std::filesystem;

fs::path case_directory(const fs::path& input) {
    if (fs::is_directory(input)) return input;
    if (input.filename() == "controlDict") return fs::absolute(input).parent_path().parent_path();
    return fs::absolute(input).parent_path();
}

bool is_decomposed(const fs::path& directory) {
    return !fs::exists(directory / "constant/polyMesh") && fs::exists(directory / "processor0");
}

bool is_time(const std::string& name) {
    char* end = nullptr;
    std::strtod(name.c_str(), &end);
    return !name.empty() && *end == '\0';
}

std::string read_start(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string head(4096, '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    return head;
}

class OpenFoamSource : public ReaderSource {
public:
    OpenFoamSource(const std::string& input, const vtkSmartPointer<vtkPOpenFOAMReader>& reader)
        : ReaderSource(is_decomposed(case_directory(input)) ? "OpenFOAM case (decomposed)" : "OpenFOAM case", input,
                       reader),
          directory_(case_directory(input)) {
        reader->EnableAllPatchArrays();
        reader->EnableAllCellArrays();
    }

    [[nodiscard]] std::map<std::string, std::string> units() const override {
        std::map<std::string, std::string> found;
        const fs::path root = is_decomposed(directory_) ? directory_ / "processor0" : directory_;
        for (const auto& time : fs::directory_iterator(root)) {
            if (!time.is_directory() || !is_time(time.path().filename().string())) continue;
            for (const auto& field : fs::directory_iterator(time.path())) {
                const std::string name = field.path().filename().string();
                if (field.is_regular_file() && !found.contains(name))
                    found[name] = openfoam_units(read_start(field.path()));
            }
        }
        return found;
    }

    [[nodiscard]] bool cut_into_pieces() const override { return is_decomposed(directory_); }
    [[nodiscard]] std::string length_units() const override { return "m"; } // OpenFOAM is SI throughout

private:
    fs::path directory_;
};

} // namespace

bool is_openfoam(const Head& head) {
    if (!head.directory && head.extension != ".foam" && head.path.filename() != "controlDict") return false;
    const fs::path directory = case_directory(head.path);
    return fs::exists(directory / "constant/polyMesh") || fs::exists(directory / "processor0") ||
           fs::exists(directory / "constant/regionProperties");
}

std::unique_ptr<Source> open_openfoam(const Inputs& inputs, const SourceOptions&) {
    const fs::path directory = case_directory(inputs.front());
    vtkNew<vtkPOpenFOAMReader> reader;
    // The reader looks at the directory of this name alone: the file need not exist.
    reader->SetFileName((directory / "case.foam").c_str());
    reader->SetCaseType(is_decomposed(directory) ? vtkPOpenFOAMReader::DECOMPOSED_CASE
                                                 : vtkPOpenFOAMReader::RECONSTRUCTED_CASE);
    reader->SetDecomposePolyhedra(0);
    reader->SetCreateCellToPoint(0);
    reader->SetCacheMesh(1);
    reader->SetReadZones(1);
    reader->SetController(vtkNew<vtkDummyController>()); // without one it dereferences null in a decomposed case
    return std::make_unique<OpenFoamSource>(inputs.front(), reader.Get());
}

} // namespace ciel::importer
