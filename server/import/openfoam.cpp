// OpenFOAM cases: a directory, its controlDict, or the empty .foam file beside them. Polyhedra stay polyhedra, cell
// data stays cell data, every patch comes with its own values, and zones are named.
#include "ciel/types.hpp"
#include "import/formats.hpp"
#include "import/parsers/openfoam_units.hpp"
#include "import/reader_source.hpp"
#include "import/regular_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <regex>
#include <vtkDummyController.h>
#include <vtkNew.h>
#include <vtkPOpenFOAMReader.h>

namespace ciel::importer {

namespace {

namespace fs = std::filesystem;
constexpr std::string_view gzip_signature = "\x1f\x8b";

fs::path case_directory(const fs::path& input) {
    if (fs::is_directory(input)) return input;
    if (input.filename() == "controlDict") return fs::absolute(input).parent_path().parent_path();
    return fs::absolute(input).parent_path();
}

bool is_time(const std::string& name) {
    char* end = nullptr;
    std::strtod(name.c_str(), &end);
    return !name.empty() && *end == '\0';
}

// "class volScalarField;": what the reader makes cell data of.
bool is_cell_field(const std::string& head) {
    static const std::regex entry(R"(\bclass\s+vol\w+Field)");
    return std::regex_search(head, entry);
}

std::string read_start(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string head(4096, '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    return head;
}

std::vector<fs::path> time_directories(const fs::path& directory) {
    std::vector<fs::path> times;
    for (const auto& entry : fs::directory_iterator(directory))
        if (entry.is_directory() && is_time(entry.path().filename().string())) times.push_back(entry.path());
    return times;
}

double time_of(const fs::path& directory) { return std::strtod(directory.filename().c_str(), nullptr); }

double latest_time(const fs::path& directory) {
    double latest = -std::numeric_limits<double>::infinity();
    for (const fs::path& time : time_directories(directory)) latest = std::max(latest, time_of(time));
    return latest;
}

// "processors4": all pieces in one file.
std::string collated_directory(const fs::path& directory) {
    for (const auto& entry : fs::directory_iterator(directory)) {
        std::string name = entry.path().filename().string();
        if (entry.is_directory() && name.starts_with("processors") && name.size() > 10) return name;
    }
    return "";
}

bool has_mesh(const fs::path& directory) {
    return fs::exists(directory / "constant/polyMesh") || fs::exists(directory / "constant/regionProperties");
}

// Where the results are. decomposePar leaves the whole mesh in place, and so do the solvers that write into its pieces.
struct Layout {
    explicit Layout(const fs::path& input) : directory(case_directory(input)), results(directory) {
        const fs::path first = directory / "processor0";
        const std::string collated = collated_directory(directory);
        if (!has_mesh(directory) && !fs::exists(first))
            throw Error(input.string() + ": is decomposed into collated files (" + collated +
                        "), which cannot be read; reconstructPar makes one case of them");
        decomposed = fs::exists(first) && (!has_mesh(directory) || latest_time(first) > latest_time(directory));
        if (decomposed) results = first;
        if (decomposed && has_mesh(directory))
            note = "The processor directories were read: they have later times than the whole case.";
        if (!decomposed && !collated.empty() && latest_time(directory / collated) > latest_time(directory))
            note = "The later times in " + collated +
                   " (collated files) were not read; reconstructPar makes them readable.";
    }

    // The case, or its processors' directories.
    [[nodiscard]] std::vector<fs::path> parts() const {
        if (!decomposed) return {directory};
        std::vector<fs::path> all;
        for (int i = 0; fs::is_directory(directory / ("processor" + std::to_string(i))); ++i)
            all.push_back(directory / ("processor" + std::to_string(i)));
        return all;
    }

    fs::path directory;
    fs::path results; // has the times
    bool decomposed = false;
    std::string note;
};

class OpenFoamSource : public ReaderSource {
public:
    OpenFoamSource(const std::string& input, Layout layout, const vtkSmartPointer<vtkPOpenFOAMReader>& reader)
        : ReaderSource(layout.decomposed ? "OpenFOAM case (decomposed)" : "OpenFOAM case", input, reader),
          layout_(std::move(layout)) {
        reader->EnableAllPatchArrays();
        reader->EnableAllCellArrays();
    }

    [[nodiscard]] vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) override {
        for (const fs::path& part : layout_.parts())
            for (const fs::path& time : time_directories(part))
                if (time_of(time) == times()[step]) require_regular_files(time);
        return ReaderSource::read(step, progress);
    }

    [[nodiscard]] std::map<std::string, std::string> units() const override {
        std::map<std::string, std::string> found;
        for (const auto& [name, head] : field_heads()) found[name] = openfoam_units(head);
        return found;
    }

    // Of all times: the reader itself lists those of the first.
    [[nodiscard]] std::optional<std::vector<ArrayName>> listed_arrays(std::size_t) const override {
        std::vector<ArrayName> listed;
        for (const auto& [name, head] : field_heads())
            if (is_cell_field(head) || head.starts_with(gzip_signature)) listed.push_back({FieldOf::cells, name});
        return listed;
    }

    [[nodiscard]] bool cut_into_pieces() const override { return layout_.decomposed; }
    [[nodiscard]] std::vector<std::string> notes() const override {
        return layout_.note.empty() ? std::vector<std::string>{} : std::vector{layout_.note};
    }
    [[nodiscard]] std::string length_units() const override { return "m"; } // OpenFOAM is SI throughout

private:
    // How the first file of each name begins, over all times and regions.
    [[nodiscard]] std::map<std::string, std::string> field_heads() const {
        std::map<std::string, std::string> heads;
        for (const fs::path& time : time_directories(layout_.results)) add_heads(time, heads);
        return heads;
    }

    void add_heads(const fs::path& directory, std::map<std::string, std::string>& heads) const {
        for (const auto& entry : fs::directory_iterator(directory)) {
            const bool compressed = entry.path().extension() == ".gz";
            const std::string name = (compressed ? entry.path().stem() : entry.path().filename()).string();
            const bool region = entry.is_directory() && fs::exists(layout_.results / "constant" / name / "polyMesh");
            if (region)
                add_heads(entry.path(), heads);
            else if (entry.is_regular_file() && !heads.contains(name))
                heads[name] = read_start(entry.path());
        }
    }

    Layout layout_;
};

} // namespace

bool is_openfoam(const Head& head) {
    if (!head.directory && head.extension != ".foam" && head.path.filename() != "controlDict") return false;
    const fs::path directory = case_directory(head.path);
    return has_mesh(directory) || fs::exists(directory / "processor0") ||
           (fs::is_directory(directory) && !collated_directory(directory).empty());
}

std::unique_ptr<Source> open_openfoam(const Inputs& inputs, const SourceOptions&) {
    Layout layout(inputs.front());
    // What the reader opens to learn what there is.
    require_regular(layout.directory / "system/controlDict");
    for (const fs::path& part : layout.parts()) require_regular_files(part / "constant/polyMesh");
    for (const fs::path& time : time_directories(layout.results)) require_regular_files(time);
    vtkNew<vtkPOpenFOAMReader> reader;
    // The reader looks at the directory of this name alone: the file need not exist.
    reader->SetFileName((layout.directory / "case.foam").c_str());
    reader->SetCaseType(layout.decomposed ? vtkPOpenFOAMReader::DECOMPOSED_CASE
                                          : vtkPOpenFOAMReader::RECONSTRUCTED_CASE);
    reader->SetDecomposePolyhedra(0);
    reader->SetCreateCellToPoint(0);
    reader->SetCacheMesh(1);
    reader->SetReadZones(1);
    reader->SetController(vtkNew<vtkDummyController>()); // without one it dereferences null in a decomposed case
    return std::make_unique<OpenFoamSource>(inputs.front(), std::move(layout), reader.Get());
}

} // namespace ciel::importer
