#include "import/readers/reader_source.hpp"

#include "ciel/types.hpp"
#include "import/readers/vtk_errors.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDataObjectTree.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkVersionMacros.h>

namespace server::importer {

namespace {

// Keeps an exception of `progress` until VTK returns, because VTK's pipeline is not exception-safe.
struct Watch {
    const ReadProgress& progress;
    std::exception_ptr thrown;
};

void on_progress(vtkObject* caller, unsigned long, void* client_data, void*) {
    auto* watch = static_cast<Watch*>(client_data);
    auto* reader = static_cast<vtkAlgorithm*>(caller);
    if (watch->thrown) return;
    try {
        watch->progress(std::clamp(reader->GetProgress(), 0.0, 1.0));
    } catch (...) {
        watch->thrown = std::current_exception();
        reader->SetAbortExecute(1);
    }
}

} // namespace

ReaderSource::ReaderSource(std::string format, std::string file, vtkSmartPointer<vtkAlgorithm> reader,
                           const ListArrays& list_arrays, std::uint64_t most_steps)
    : format_(std::move(format)), file_(std::move(file)), reader_(std::move(reader)) {
    reader_->UpdateInformation();
    throw_vtk_errors(file_);
    vtkInformation* information = reader_->GetOutputInformation(0);
    auto* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
    if (information->Has(key)) {
        const double* values = information->Get(key);
        const auto steps = static_cast<std::uint64_t>(information->Length(key));
        times_.assign(values, values + std::min(steps, most_steps));
    }
    if (times_.empty()) times_ = {0.0};
    if (list_arrays) arrays_ = list_arrays();
    if (!std::is_sorted(times_.begin(), times_.end()))
        throw ciel::Error(file_ + ": its time steps are not in ascending order; sort them in the file");
}

vtkSmartPointer<vtkDataObject> ReaderSource::read(std::size_t step, const ReadProgress& progress) {
    Watch watch{progress, nullptr};
    vtkNew<vtkCallbackCommand> observer;
    observer->SetCallback(on_progress);
    observer->SetClientData(&watch);
    const unsigned long tag = reader_->AddObserver(vtkCommand::ProgressEvent, observer);
    if (reader_->GetOutputInformation(0)->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()))
        reader_->UpdateTimeStep(times_[step]);
    else
        reader_->Update();
    reader_->RemoveObserver(tag);
    if (watch.thrown) std::rethrow_exception(watch.thrown);
    throw_vtk_errors(file_);

    vtkDataObject* output = reader_->GetOutputDataObject(0);
    if (output == nullptr)
        throw ciel::Error(
            file_ + ": VTK's reader returned no data; the file may be damaged, or of a kind that VTK does not know");
    return kept(*output);
}

std::string ReaderSource::file_of(const ArrayName&, std::size_t) const {
    return std::filesystem::path(file_).filename().string();
}

vtkSmartPointer<vtkDataObject> kept(vtkDataObject& output) {
    vtkSmartPointer<vtkDataObject> copy = vtk::TakeSmartPointer(output.NewInstance());
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
    // Before VTK 9.3, ShallowCopy() of a tree does not copy the leaves: both trees share the leaves.
    if (auto* tree = vtkDataObjectTree::SafeDownCast(copy)) {
        tree->RecursiveShallowCopy(&output);
        return copy;
    }
#endif
    copy->ShallowCopy(&output);
    return copy;
}

} // namespace server::importer
