// A Source over one VTK reader: most formats need no more.
#pragma once

#include "import/source.hpp"

#include <vtkAlgorithm.h>

namespace ciel::importer {

class ReaderSource : public Source {
public:
    // `reader` has its file name set; `file` is named in errors. Reads the information of the file.
    ReaderSource(std::string format, std::string file, vtkSmartPointer<vtkAlgorithm> reader);

    [[nodiscard]] std::string format() const override { return format_; }
    [[nodiscard]] const std::vector<double>& times() const override { return times_; }
    [[nodiscard]] vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) override;

private:
    std::string format_;
    std::string file_;
    vtkSmartPointer<vtkAlgorithm> reader_;
    std::vector<double> times_;
};

} // namespace ciel::importer
