#include "import/readers/piece_reading.hpp"

#include "ciel/types.hpp"

#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>

namespace ciel::importer {

namespace {

vtkSmartPointer<vtkDataObject> together(const std::vector<vtkSmartPointer<vtkDataObject>>& pieces,
                                        const std::vector<std::string>& names) {
    vtkNew<vtkPartitionedDataSet> partitions;
    vtkNew<vtkMultiBlockDataSet> data_sets;
    bool are_data_sets = true;
    for (const auto& piece : pieces) are_data_sets = are_data_sets && vtkDataSet::SafeDownCast(piece) != nullptr;
    for (unsigned i = 0; i < pieces.size(); ++i) {
        if (are_data_sets)
            partitions->SetPartition(i, pieces[i]);
        else
            data_sets->SetBlock(i, pieces[i]);
        if (names.empty()) continue;
        vtkInformation* information = are_data_sets ? partitions->GetMetaData(i) : data_sets->GetMetaData(i);
        information->Set(vtkCompositeDataSet::NAME(), names[i].c_str());
    }
    if (are_data_sets) return partitions.Get();
    return data_sets.Get();
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
        } catch (const Error& error) {
            if (first_reason.empty()) first_reason = error.what();
            lost.push_back(std::string("A piece could not be read and was left out: ") + error.what());
        }
    }
    if (pieces.empty()) throw Error(first_reason.empty() ? "the file names no pieces" : first_reason);
    return together(pieces, names);
}

} // namespace ciel::importer
