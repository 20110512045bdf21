// LS-DYNA databases: the file family d3plot, d3plot01, d3plot02..., or an XML file that lists the files of the family.
#include "ciel/types.hpp"
#include "import/readers/formats.hpp"
#include "import/readers/reader_source.hpp"
#include "import/readers/regular_file.hpp"

#include <cstdlib>
#include <fstream>
#include <vtkLSDynaReader.h>
#include <vtkNew.h>

namespace server::importer {

namespace {

namespace fs = std::filesystem;

// Adds an empty second file, because VTK's reader closes an only file at the end marker and does not reopen it.
class PairedFamily {
public:
    explicit PairedFamily(const fs::path& only) {
        std::string pattern = (fs::temp_directory_path() / "ciel-lsdyna-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr)
            throw ciel::Error("cannot make a temporary directory; check the free space and the permissions of " +
                              fs::temp_directory_path().string());
        directory_ = pattern;
        fs::create_symlink(fs::absolute(only), first());
        std::ofstream(directory_ / "d3plot01");
    }
    ~PairedFamily() {
        std::error_code ignored;
        fs::remove_all(directory_, ignored);
    }
    PairedFamily(const PairedFamily&) = delete;
    PairedFamily& operator=(const PairedFamily&) = delete;

    [[nodiscard]] fs::path first() const { return directory_ / "d3plot"; }

private:
    fs::path directory_;
};

bool is_alone(const fs::path& file) {
    return file.extension() != ".lsdyna" && !fs::exists(fs::path(file).concat("01"));
}

class LsDynaSource : public ReaderSource {
public:
    LsDynaSource(const std::string& file, vtkLSDynaReader* reader, std::unique_ptr<PairedFamily> family)
        : ReaderSource("LS-DYNA", file, reader), family_(std::move(family)) {}

private:
    std::unique_ptr<PairedFamily> family_; // must exist while the reader reads
};

} // namespace

std::unique_ptr<Source> open_lsdyna(const Inputs& inputs, const SourceOptions&) {
    // For an XML file, checks all files in its folder.
    const fs::path input = inputs.front();
    require_regular_files(input.parent_path(), input.extension() == ".lsdyna" ? "" : input.filename().string());
    auto family = is_alone(inputs.front()) ? std::make_unique<PairedFamily>(inputs.front()) : nullptr;
    vtkNew<vtkLSDynaReader> reader;
    reader->SetFileName(family ? family->first().c_str() : inputs.front().c_str());
    reader->SetDeformedMesh(1); // reads the positions of each step, so that the mesh moves
    reader->UpdateInformation();
    for (int i = 0; i < reader->GetNumberOfPointArrays(); ++i) reader->SetPointArrayStatus(i, 1);
    for (int i = 0; i < reader->GetNumberOfSolidArrays(); ++i) reader->SetSolidArrayStatus(i, 1);
    return std::make_unique<LsDynaSource>(inputs.front(), reader.Get(), std::move(family));
}

} // namespace server::importer
