// Legacy VTK files of any data set type; what they declare is held against their size first.
#include "import/formats.hpp"
#include "import/parsers/legacy_vtk_counts.hpp"
#include "import/parsers/legacy_vtk_numbers.hpp"
#include "import/reader_source.hpp"

#include <fstream>
#include <iterator>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace ciel::importer {

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

// An ascii file that holds values which are no numbers.
class StandInSource : public ReaderSource {
public:
    using ReaderSource::ReaderSource;

    [[nodiscard]] vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) override {
        auto data = ReaderSource::read(step, progress);
        if (auto* set = vtkDataSet::SafeDownCast(data))
            for (vtkDataSetAttributes* arrays : {static_cast<vtkDataSetAttributes*>(set->GetPointData()),
                                                 static_cast<vtkDataSetAttributes*>(set->GetCellData())})
                for (int i = 0; i < arrays->GetNumberOfArrays(); ++i) {
                    put_back<vtkFloatArray>(arrays->GetArray(i));
                    put_back<vtkDoubleArray>(arrays->GetArray(i));
                }
        return data;
    }
};

// The third line says whether a file is text.
bool is_ascii(std::istream& stream) {
    std::string line;
    for (int i = 0; i < 3; ++i) std::getline(stream, line);
    stream.clear();
    stream.seekg(0);
    return line.starts_with("ASCII");
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
    if (!is_ascii(stream) || !may_hold_no_numbers(stream))
        return std::make_unique<ReaderSource>("legacy VTK", file, reader.Get());
    stream.clear();
    stream.seekg(0);
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const std::string readable = with_stand_ins(text);
    reader->ReadFromInputStringOn();
    reader->SetBinaryInputString(readable.data(), static_cast<vtkIdType>(readable.size()));
    return std::make_unique<StandInSource>("legacy VTK", file, reader.Get());
}

} // namespace ciel::importer
