// EnSight Gold: a case file that lists the files of the geometry and the variables.
#include "ciel/types.hpp"
#include "import/readers/formats.hpp"
#include "import/readers/reader_source.hpp"
#include "import/readers/regular_file.hpp"

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkGenericEnSightReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace server::importer {

namespace {

// Any word of the line may be a file name. In a file name, "*" means the digits of a time step.
void require_regular_words(const std::string& line, const std::filesystem::path& directory) {
    std::istringstream words(line);
    for (std::string word; words >> word;) {
        const std::filesystem::path file = directory / word;
        const std::string name = file.filename().string();
        const std::size_t star = name.find('*');
        if (star == std::string::npos)
            require_regular(file);
        else if (star > 0)
            require_regular_files(file.parent_path(), name.substr(0, star));
    }
}

// The name is the second to last word, as in "tensor symm per node: 1 stress stress.***".
std::string tensor_in(const std::string& line) {
    if (!line.starts_with("tensor")) return "";
    std::istringstream words(line.substr(std::min(line.find(':'), line.size() - 1) + 1));
    std::string name, last;
    for (std::string word; words >> word; last = word) name = last;
    return name;
}

struct Case {
    std::set<std::string> tensors;
};

Case read_case(const std::string& input) {
    std::ifstream file(input, std::ios::binary);
    Case found;
    bool has_geometry = false;
    for (std::string line; std::getline(file, line);) {
        has_geometry = has_geometry || line.find("GEOMETRY") != std::string::npos;
        require_regular_words(line, std::filesystem::path(input).parent_path());
        if (std::string tensor = tensor_in(line); !tensor.empty()) found.tensors.insert(std::move(tensor));
    }
    if (!has_geometry)
        throw ciel::Error(
            input + ": has no section GEOMETRY and names no mesh; give the case file that has a section GEOMETRY");
    return found;
}

// VTK's reader does not name components, and swaps the last two components of a symmetric tensor.
void name_components(vtkDataSetAttributes& arrays, const std::set<std::string>& tensors) {
    constexpr const char* symmetric[] = {"xx", "yy", "zz", "xy", "yz", "xz"};
    constexpr const char* full[] = {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
    for (const std::string& name : tensors) {
        vtkDataArray* array = arrays.GetArray(name.c_str());
        const int components = array == nullptr ? 0 : array->GetNumberOfComponents();
        if (components != 6 && components != 9) continue;
        for (int c = 0; c < components; ++c) array->SetComponentName(c, components == 6 ? symmetric[c] : full[c]);
    }
}

class EnSightSource : public ReaderSource {
public:
    EnSightSource(const std::string& file, vtkGenericEnSightReader* reader, Case from)
        : ReaderSource("EnSight", file, reader, [&] { return arrays_of(*reader); }), case_(std::move(from)) {}

    [[nodiscard]] vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) override {
        auto data = ReaderSource::read(step, progress);
        for (const InputGrid& input_grid : collect_input_grids(data).volumes) {
            name_components(*input_grid.data->GetPointData(), case_.tensors);
            name_components(*input_grid.data->GetCellData(), case_.tensors);
        }
        return data;
    }

private:
    Case case_;
};

} // namespace

std::unique_ptr<Source> open_ensight(const Inputs& inputs, const SourceOptions&) {
    Case from = read_case(inputs.front());
    vtkNew<vtkGenericEnSightReader> reader;
    reader->SetCaseFileName(inputs.front().c_str());
    reader->ReadAllVariablesOn();
    return std::make_unique<EnSightSource>(inputs.front(), reader.Get(), std::move(from));
}

} // namespace server::importer
