// Legacy VTK files of any type of vtkDataSet. Declared counts are checked against the file's size before VTK reads the
// file.
#include "ciel/types.hpp"
#include "import/parsers/legacy_vtk_counts.hpp"
#include "import/parsers/legacy_vtk_numbers.hpp"
#include "import/readers/formats.hpp"
#include "import/readers/reader_source.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <limits>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkRectilinearGrid.h>

namespace server::importer {

namespace {

template <class Array>
void put_back(vtkDataArray* array) {
    auto* own = Array::SafeDownCast(array);
    if (own == nullptr) return;
    using Value = typename Array::ValueType;
    for (vtkIdType i = 0; i < own->GetNumberOfValues(); ++i)
        for (const StandIn& stand_in : stand_ins)
            if (own->GetValue(i) == static_cast<Value>(stand_in.number))
                own->SetValue(i, static_cast<Value>(stand_in.value));
}

void put_back(vtkDataArray* array) {
    put_back<vtkFloatArray>(array);
    put_back<vtkDoubleArray>(array);
}

// Treats coordinates too: the import refuses points that are not finite, but would accept a stand-in such as 3e38.
void put_back(vtkDataSet& set) {
    for (vtkDataSetAttributes* arrays : {static_cast<vtkDataSetAttributes*>(set.GetPointData()),
                                         static_cast<vtkDataSetAttributes*>(set.GetCellData())})
        for (int i = 0; i < arrays->GetNumberOfArrays(); ++i) put_back(arrays->GetArray(i));
    if (auto* points = vtkPointSet::SafeDownCast(&set); points != nullptr && points->GetPoints() != nullptr)
        put_back(points->GetPoints()->GetData());
    if (auto* grid = vtkRectilinearGrid::SafeDownCast(&set))
        for (vtkDataArray* axis : {grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates()})
            put_back(axis);
}

// Reads a text file with NaN or infinities. VTK reads finite stand-ins (legacy_vtk_numbers.hpp) instead.
class StandInSource : public ReaderSource {
public:
    StandInSource(const std::string& file, vtkSmartPointer<vtkAlgorithm> reader)
        : ReaderSource("legacy VTK", file, std::move(reader)), file_(file) {}

    [[nodiscard]] vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) override {
        try {
            auto data = ReaderSource::read(step, progress);
            if (auto* set = vtkDataSet::SafeDownCast(data)) put_back(*set);
            return data;
        } catch (const ciel::Error& error) {
            const std::string what = error.what();
            // In an integer array, VTK reads only the first digit of a stand-in. VTK's error quotes the other digits.
            for (const StandIn& stand_in : stand_ins)
                if (what.find(std::string(stand_in.text).substr(2)) != std::string::npos)
                    throw ciel::Error(file_ + ": holds nan or inf where whole numbers are declared");
            throw;
        }
    }

private:
    std::string file_;
};

bool is_ascii(std::istream& stream) {
    std::string line;
    for (int i = 0; i < 3; ++i) std::getline(stream, line);
    std::transform(line.begin(), line.end(), line.begin(), [](unsigned char c) { return std::toupper(c); });
    stream.clear();
    stream.seekg(0);
    return line.find("ASCII") != std::string::npos;
}

} // namespace

std::unique_ptr<Source> open_legacy_vtk(const Inputs& inputs, const SourceOptions&) {
    const std::string& file = inputs.front();
    std::ifstream stream(file, std::ios::binary);
    check_legacy_vtk_counts(stream, std::filesystem::file_size(file), file);
    stream.clear();
    stream.seekg(0);
    vtkNew<vtkGenericDataObjectReader> reader;
    reader->SetFileName(file.c_str());
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllNormalsOn();
    reader->ReadAllTensorsOn();
    reader->ReadAllFieldsOn();
    if (!is_ascii(stream) || !holds_no_numbers(stream))
        return std::make_unique<ReaderSource>("legacy VTK", file, reader.Get());
    stream.clear();
    stream.seekg(0);
    const std::string readable = with_stand_ins(stream);
    if (readable.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw ciel::Error(
            file +
            ": has more than 2 GiB of text that holds nan or inf, which cannot be read; write the file in binary");
    reader->ReadFromInputStringOn();
    reader->SetBinaryInputString(readable.data(), static_cast<int>(readable.size()));
    return std::make_unique<StandInSource>(file, reader.Get());
}

} // namespace server::importer
