// A Source that wraps one VTK reader. Most formats need nothing else.
#pragma once

#include "import/source/source.hpp"

#include <vtkAlgorithm.h>

namespace server::importer {

class ReaderSource : public Source {
public:
    using ListArrays = std::function<std::vector<ArrayName>()>;

    // The file name of `reader` must be set. `file`: path for error texts. `list_arrays`: null if the reader cannot
    // list the names of its output arrays. `most_steps`: steps after this number of steps are ignored.
    ReaderSource(std::string format, std::string file, vtkSmartPointer<vtkAlgorithm> reader,
                 const ListArrays& list_arrays = nullptr, std::uint64_t most_steps = ~std::uint64_t{0});

    [[nodiscard]] std::string format() const override { return format_; }
    [[nodiscard]] const std::vector<double>& times() const override { return times_; }
    [[nodiscard]] vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) override;
    [[nodiscard]] std::string file_of(const ArrayName&, std::size_t) const override;
    [[nodiscard]] std::optional<std::vector<ArrayName>> listed_arrays(std::size_t) const override { return arrays_; }

private:
    std::string format_;
    std::string file_;
    vtkSmartPointer<vtkAlgorithm> reader_;
    std::vector<double> times_;
    std::optional<std::vector<ArrayName>> arrays_;
};

// Returns a shallow copy of a reader's output, because the reader writes its next step into the same object.
[[nodiscard]] vtkSmartPointer<vtkDataObject> kept(vtkDataObject& output);

// Lists the arrays of a reader with GetNumberOfPointArrays() and similar functions, which most VTK readers have.
template <typename Reader>
std::vector<ArrayName> arrays_of(Reader& reader) {
    std::vector<ArrayName> arrays;
    const auto points = static_cast<std::size_t>(reader.GetNumberOfPointArrays());
    const auto cells = static_cast<std::size_t>(reader.GetNumberOfCellArrays());
    arrays.reserve(points + cells);
    for (int i = 0; i < reader.GetNumberOfPointArrays(); ++i)
        arrays.push_back({FieldOf::points, reader.GetPointArrayName(i)});
    for (int i = 0; i < reader.GetNumberOfCellArrays(); ++i)
        arrays.push_back({FieldOf::cells, reader.GetCellArrayName(i)});
    return arrays;
}

} // namespace server::importer
