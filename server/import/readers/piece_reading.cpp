#include "import/readers/piece_reading.hpp"

#include "ciel/types.hpp"

#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>

namespace server::importer {

namespace {

vtkSmartPointer<vtkDataObject> together(const std::vector<vtkSmartPointer<vtkDataObject>>& pieces,
                                        const std::vector<std::string>& names) {
    vtkNew<vtkPartitionedDataSet> partitions;
    vtkNew<vtkMultiBlockDataSet> multiblock;
    bool are_leaves = true;
    for (const auto& piece : pieces) are_leaves = are_leaves && vtkDataSet::SafeDownCast(piece) != nullptr;
    for (unsigned i = 0; i < pieces.size(); ++i) {
        if (are_leaves)
            partitions->SetPartition(i, pieces[i]);
        else
            multiblock->SetBlock(i, pieces[i]);
        if (names.empty()) continue;
        vtkInformation* information = are_leaves ? partitions->GetMetaData(i) : multiblock->GetMetaData(i);
        information->Set(vtkCompositeDataSet::NAME(), names[i].c_str());
    }
    if (are_leaves) return partitions.Get();
    return multiblock.Get();
}

} // namespace

vtkSmartPointer<vtkDataObject>
read_pieces(std::size_t count,
            const std::function<vtkSmartPointer<vtkDataObject>(std::size_t piece, const ReadProgress&)>& read,
            const std::function<std::string(std::size_t piece)>& name, std::vector<std::string>& lost,
            const ReadProgress& progress) {
    std::vector<vtkSmartPointer<vtkDataObject>> pieces;
    std::vector<std::string> names;
    std::string first_reason;
    for (std::size_t i = 0; i < count; ++i) {
        try {
            pieces.push_back(read(
                i, [&](double share) { progress((static_cast<double>(i) + share) / static_cast<double>(count)); }));
            if (name) names.push_back(name(i));
        } catch (const ciel::Error& error) {
            if (first_reason.empty()) first_reason = error.what();
            lost.push_back(std::string("A piece could not be read and was left out: ") + error.what());
        }
    }
    if (pieces.empty()) throw ciel::Error(first_reason.empty() ? "the file names no pieces" : first_reason);
    return together(pieces, names);
}

} // namespace server::importer
