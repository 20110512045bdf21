// PLOT3D: a grid and its solutions, one per time step. parsers/plot3d_layout.hpp finds the layout of the files.
#include "ciel/types.hpp"
#include "import/parsers/plot3d_layout.hpp"
#include "import/readers/formats.hpp"
#include "import/readers/reader_source.hpp"
#include "import/readers/vtk_errors.hpp"
#include "importing/freshness.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <vtkCommand.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiBlockPLOT3DReader.h>
#include <vtkNew.h>

namespace server::importer {

namespace {

constexpr int pressure = 110;
constexpr int velocity = 200;

std::string read_start(const std::string& file, std::size_t most) {
    std::ifstream stream(file, std::ios::binary);
    std::string head(most, '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    return head;
}

bool is_text(std::string_view head) {
    return !head.empty() && head.find_first_not_of("0123456789+-.eEdD, \t\r\n") == std::string_view::npos;
}

std::uint64_t count_numbers(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    std::uint64_t count = 0;
    bool inside = false;
    std::vector<char> buffer(1U << 16);
    while (stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || stream.gcount() > 0)
        for (std::streamsize i = 0; i < stream.gcount(); ++i) {
            const bool space = std::strchr(" \t\r\n,", buffer[static_cast<std::size_t>(i)]) != nullptr;
            count += !space && !inside ? 1 : 0;
            inside = !space;
        }
    return count;
}

std::vector<Plot3dLayout> layouts_of(const std::string& file, Plot3dKind kind) {
    const std::string head = read_start(file, plot3d_head_bytes);
    if (is_text(head)) return plot3d_text_layouts(head, count_numbers(file), kind);
    return plot3d_binary_layouts(std::as_bytes(std::span(head)), std::filesystem::file_size(file), kind);
}

class Plot3dSource : public Source {
public:
    Plot3dSource(const Inputs& inputs, const Plot3dLayout& layout, std::vector<std::string> notes)
        : inputs_(inputs), notes_(std::move(notes)) {
        reader_->AutoDetectFormatOff();
        reader_->SetBinaryFile(layout.text ? 0 : 1);
        reader_->SetByteOrder(layout.big_endian ? vtkMultiBlockPLOT3DReader::FILE_BIG_ENDIAN
                                                : vtkMultiBlockPLOT3DReader::FILE_LITTLE_ENDIAN);
        reader_->SetMultiGrid(layout.multi_grid);
        reader_->SetHasByteCount(layout.byte_counts);
        reader_->SetDoublePrecision(layout.double_precision);
        reader_->SetIBlanking(layout.iblank);
        reader_->SetXYZFileName(inputs[0].c_str());
        reader_->SetScalarFunctionNumber(-1);
        reader_->SetVectorFunctionNumber(-1);
        if (inputs.size() > 1)
            for (const int function : {pressure, velocity}) reader_->AddFunction(function);
        for (std::size_t i = 0; i + 1 < std::max<std::size_t>(inputs.size(), 2); ++i)
            times_.push_back(static_cast<double>(i));
    }

    [[nodiscard]] std::string format() const override { return "PLOT3D"; }
    [[nodiscard]] const std::vector<double>& times() const override { return times_; }
    [[nodiscard]] std::vector<std::string> notes() const override { return notes_; }
    [[nodiscard]] std::string file_of(const ArrayName&, std::size_t step) const override {
        return std::filesystem::path(inputs_[std::min(step + 1, inputs_.size() - 1)]).filename().string();
    }
    // VTK's reader computes pressure and velocity from density, momentum and energy in the solution file.
    [[nodiscard]] bool is_derived(const ArrayName& array) const override {
        return array.name == "Pressure" || array.name == "Velocity";
    }
    [[nodiscard]] vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) override {
        progress(0);
        if (inputs_.size() > 1) reader_->SetQFileName(inputs_[step + 1].c_str());
        reader_->Update();
        throw_vtk_errors(inputs_[0]);
        vtkSmartPointer<vtkDataObject> output = kept(*reader_->GetOutput());
        progress(1);
        return output;
    }

private:
    Inputs inputs_;
    std::vector<std::string> notes_;
    vtkNew<vtkMultiBlockPLOT3DReader> reader_;
    std::vector<double> times_;
};

std::vector<Plot3dLayout> agreeing(std::vector<Plot3dLayout> grids, const std::vector<Plot3dLayout>& solutions) {
    std::erase_if(grids, [&](const Plot3dLayout& grid) {
        return std::none_of(solutions.begin(), solutions.end(),
                            [&](const Plot3dLayout& solution) { return plot3d_match(grid, solution); });
    });
    return grids;
}

std::vector<Plot3dLayout> grid_layouts(const std::string& grid, const std::string& words) {
    std::vector<Plot3dLayout> grids = plot3d_restrict(layouts_of(grid, Plot3dKind::grid), words);
    if (!grids.empty()) return grids;
    throw ciel::Error(grid + ": is not a PLOT3D grid" + (words.empty() ? "" : " of the layout --plot3d " + words) +
                      ": the size of the file does not match the dimensions in the file");
}

Plot3dLayout choose_layout(const Inputs& inputs, const std::string& words) {
    std::vector<Plot3dLayout> grids = grid_layouts(inputs[0], words);
    for (std::size_t i = 1; i < inputs.size(); ++i) {
        const std::vector<Plot3dLayout> solutions = layouts_of(inputs[i], Plot3dKind::solution);
        if (solutions.empty())
            throw ciel::Error(
                inputs[i] +
                ": is not a PLOT3D solution (q): the size of the file does not match the dimensions in the file");
        grids = agreeing(std::move(grids), solutions);
        if (grids.empty())
            throw ciel::Error(inputs[i] + ": does not belong to the grid " + inputs[0] +
                              ": dimensions or byte order differ");
    }
    return grids.front();
}

// Returns a note if there is a solution. Adds none if there are two, or if the solution does not match the grid.
std::string take_solution_beside(Inputs& inputs, const std::string& words) {
    Inputs beside;
    for (const auto& file : importing::plot3d_solutions(inputs[0])) beside.push_back(file.string());
    if (beside.empty()) return "";
    const std::string name = std::filesystem::path(beside[0]).filename().string();
    if (beside.size() > 1)
        return "Two solutions lie beside the grid, " + name + " and " +
               std::filesystem::path(beside[1]).filename().string() +
               "; neither was read. Name the solution of the grid as an input.";
    if (agreeing(grid_layouts(inputs[0], words), layouts_of(beside[0], Plot3dKind::solution)).empty())
        return name + " lies beside the grid but was not read, because its dimensions or its byte order differ from "
                      "those of the grid.";
    inputs.push_back(beside[0]);
    return "The solution was read from " + name + ", which lies beside the grid.";
}

// Returns a note if it adds a grid, and an empty text if no grid is needed or found.
std::string take_grid_beside(Inputs& inputs) {
    if (inputs.size() > 1 || !layouts_of(inputs[0], Plot3dKind::grid).empty()) return "";
    const std::filesystem::path grid = importing::plot3d_grid(inputs[0]);
    if (grid.empty() || layouts_of(grid.string(), Plot3dKind::grid).empty()) return "";
    inputs.insert(inputs.begin(), grid.string());
    return "The grid was read from " + grid.filename().string() + ", which lies beside the solution.";
}

} // namespace

bool is_plot3d(const Head& head) {
    if (head.directory) return false;
    const std::string file = head.path.string();
    return !layouts_of(file, Plot3dKind::grid).empty() || !layouts_of(file, Plot3dKind::solution).empty();
}

std::unique_ptr<Source> open_plot3d(const Inputs& inputs, const SourceOptions& options) {
    Inputs ordered = inputs;
    for (const std::string& input : inputs)
        if (std::filesystem::is_directory(input))
            throw ciel::Error(input + ": is a directory; give the files of the grid and of the solution");
    // The user may give grids and solutions in any order.
    std::stable_partition(ordered.begin(), ordered.end(),
                          [](const std::string& file) { return !layouts_of(file, Plot3dKind::grid).empty(); });
    std::vector<std::string> notes;
    if (std::string note = take_grid_beside(ordered); !note.empty()) notes.push_back(std::move(note));
    if (layouts_of(ordered[0], Plot3dKind::grid).empty())
        throw ciel::Error(ordered[0] + ": is a PLOT3D solution; give the file of its grid (xyz) as an input too");
    if (ordered.size() == 1)
        if (std::string note = take_solution_beside(ordered, options.plot3d); !note.empty())
            notes.push_back(std::move(note));
    const Plot3dLayout layout = choose_layout(ordered, options.plot3d);
    return std::make_unique<Plot3dSource>(ordered, layout, std::move(notes));
}

} // namespace server::importer
