// CGNS: zones and boundary conditions. A note lists the types of boundary conditions that VTK's reader cannot load.
#include "import/readers/formats.hpp"
#include "import/readers/reader_source.hpp"

#include <regex>
#include <set>
#include <vtkCGNSReader.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>

namespace server::importer {

namespace {

class CgnsSource : public ReaderSource {
public:
    CgnsSource(const std::string& file, vtkCGNSReader* reader) : ReaderSource("CGNS", file, reader), reader_(reader) {
        vtkNew<vtkCallbackCommand> command;
        command->SetClientData(this);
        command->SetCallback([](vtkObject*, unsigned long, void* source, void* text) {
            static_cast<CgnsSource*>(source)->hear(static_cast<const char*>(text));
        });
        warned_ = reader->AddObserver(vtkCommand::WarningEvent, command);
    }
    ~CgnsSource() override { reader_->RemoveObserver(warned_); }
    CgnsSource(const CgnsSource&) = delete;
    CgnsSource& operator=(const CgnsSource&) = delete;

    [[nodiscard]] std::vector<std::string> notes() const override {
        if (skipped_.empty()) return {};
        std::string types;
        for (const std::string& type : skipped_) types.append(types.empty() ? "" : ", ").append(type);
        return {"Boundary conditions of type " + types +
                " were not read, because only boundary conditions that name a family are read."};
    }

private:
    void hear(const char* text) {
        static const std::regex skipped("BC_t type '([^']*)' not supported");
        std::cmatch match;
        if (text != nullptr && std::regex_search(text, match, skipped)) skipped_.insert(match[1].str());
    }

    vtkSmartPointer<vtkCGNSReader> reader_;
    unsigned long warned_ = 0;
    std::set<std::string> skipped_;
};

} // namespace

std::unique_ptr<Source> open_cgns(const Inputs& inputs, const SourceOptions&) {
    vtkNew<vtkCGNSReader> reader;
    reader->SetFileName(inputs.front().c_str());
    reader->UpdateInformation();
    reader->EnableAllBases();
    reader->EnableAllFamilies();
    reader->EnableAllPointArrays();
    reader->EnableAllCellArrays();
    reader->SetLoadBndPatch(true);
    return std::make_unique<CgnsSource>(inputs.front(), reader.Get());
}

} // namespace server::importer
