// Exodus II: element blocks with their nodes, side sets as patches, element sets as zones.
#include "ciel/types.hpp"
#include "import/parsers/netcdf_extent.hpp"
#include "import/readers/exodus_sets.hpp"
#include "import/readers/formats.hpp"
#include "import/readers/reader_source.hpp"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <vtkCompositeDataSet.h>
#include <vtkExodusIIReader.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

namespace server::importer {

namespace {

vtkMultiBlockDataSet* child(vtkMultiBlockDataSet* parent, const char* name) {
    for (unsigned i = 0; i < parent->GetNumberOfBlocks(); ++i) {
        vtkInformation* information = parent->HasMetaData(i) != 0 ? parent->GetMetaData(i) : nullptr;
        const char* own = information != nullptr ? information->Get(vtkCompositeDataSet::NAME()) : nullptr;
        if (own != nullptr && std::strcmp(own, name) == 0)
            return vtkMultiBlockDataSet::SafeDownCast(parent->GetBlock(i));
    }
    return nullptr;
}

std::vector<ArrayName> arrays_of_blocks(vtkExodusIIReader& reader) {
    std::vector<ArrayName> arrays;
    for (const int type : {vtkExodusIIReader::NODAL, vtkExodusIIReader::ELEM_BLOCK})
        for (int i = 0; i < reader.GetNumberOfObjectArrays(type); ++i)
            arrays.push_back({type == vtkExodusIIReader::NODAL ? FieldOf::points : FieldOf::cells,
                              reader.GetObjectArrayName(type, i)});
    return arrays;
}

struct StepCounts {
    std::uint64_t declared = ~std::uint64_t{0}, complete = ~std::uint64_t{0};
};

// For an HDF5 file, returns default StepCounts, which are no limit: the HDF5 library itself detects a cut-off file.
StepCounts count_steps(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    const auto extent = read_netcdf_extent(stream, file);
    const std::uint64_t size = std::filesystem::file_size(file);
    if (!extent) return {};
    if (extent->fixed_end > size)
        throw ciel::Error(file + ": has " + std::to_string(size) + " of the " + std::to_string(extent->fixed_end) +
                          " bytes that its mesh needs; copy the file again");
    if (extent->records == 0) return {};
    const StepCounts steps{extent->records, extent->records_within(size)};
    if (steps.complete == 0) throw ciel::Error(file + ": ends before the end of its first step; copy the file again");
    return steps;
}

class ExodusSource : public ReaderSource {
public:
    ExodusSource(const std::string& file, vtkExodusIIReader* reader, const StepCounts& steps)
        : ReaderSource(
              "Exodus II", file, reader, [&] { return arrays_of_blocks(*reader); }, steps.complete) {
        if (steps.complete < steps.declared)
            lost_.push_back(
                file + ": ends before the end of its last step: " + std::to_string(steps.declared - steps.complete) +
                " of its " + std::to_string(steps.declared) +
                " steps are incomplete and were left out; copy the file again");
        for (int i = 0; i < reader->GetNumberOfObjects(vtkExodusIIReader::ELEM_BLOCK); ++i)
            block_ids_.push_back(reader->GetObjectId(vtkExodusIIReader::ELEM_BLOCK, i));
        for (int i = 0; i < reader->GetNumberOfObjects(vtkExodusIIReader::ELEM_SET); ++i)
            set_ids_.push_back(reader->GetObjectId(vtkExodusIIReader::ELEM_SET, i));
        if (!set_ids_.empty()) sets_ = read_element_sets(file, block_ids_, set_ids_);
    }

    // Fills the element sets. VTK's reader leaves them empty: it looks for 32-bit connectivity, but stores 64-bit.
    [[nodiscard]] vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) override {
        auto data = ReaderSource::read(step, progress);
        auto* root = vtkMultiBlockDataSet::SafeDownCast(data);
        if (root == nullptr || sets_.empty()) return data;
        vtkMultiBlockDataSet* blocks = child(root, "Element Blocks");
        vtkMultiBlockDataSet* sets = child(root, "Element Sets");
        if (blocks == nullptr || sets == nullptr) return data;
        for (unsigned i = 0; i < sets_.size(); ++i) sets->SetBlock(i, copy_cells(blocks, sets_[i]));
        return data;
    }

    [[nodiscard]] std::vector<std::string> lost() const override { return lost_; }

private:
    std::vector<std::string> lost_;
    std::vector<std::int64_t> block_ids_; // ids of the element blocks, in the order of the reader's VTK blocks
    std::vector<std::int64_t> set_ids_;
    std::vector<ElementSet> sets_;
};

} // namespace

std::unique_ptr<Source> open_exodus(const Inputs& inputs, const SourceOptions&) {
    const StepCounts steps = count_steps(inputs.front());
    vtkNew<vtkExodusIIReader> reader;
    reader->SetFileName(inputs.front().c_str());
    reader->SetApplyDisplacements(0); // does not move the points; the displacement is an array
    reader->GenerateGlobalNodeIdArrayOn();
    reader->GenerateGlobalElementIdArrayOn();
    reader->UpdateInformation();
    for (const int type : {vtkExodusIIReader::ELEM_BLOCK, vtkExodusIIReader::SIDE_SET, vtkExodusIIReader::NODAL}) {
        for (int i = 0; i < reader->GetNumberOfObjects(type); ++i) reader->SetObjectStatus(type, i, 1);
        for (int i = 0; i < reader->GetNumberOfObjectArrays(type); ++i)
            reader->SetObjectArrayStatus(type, reader->GetObjectArrayName(type, i), 1);
    }
    return std::make_unique<ExodusSource>(inputs.front(), reader.Get(), steps);
}

} // namespace server::importer
