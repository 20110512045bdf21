#include "import/readers/open_source.hpp"

#include "ciel/types.hpp"
#include "import/mesh/joined_mesh.hpp"
#include "import/readers/formats.hpp"
#include "import/readers/regular_file.hpp"

#include <algorithm>
#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

namespace server::importer {

namespace {

// The inputs are parts of one mesh and must have the same times. A step has the input grids of all inputs.
class SeveralInputs : public Source {
public:
    SeveralInputs(std::vector<std::unique_ptr<Source>> sources, const std::vector<std::string>& inputs)
        : sources_(std::move(sources)), inputs_(inputs) {
        for (std::size_t i = 1; i < sources_.size(); ++i)
            if (sources_[i]->times() != sources_[0]->times())
                throw ciel::Error(inputs[i] + ": its times differ from those of " + inputs[0] +
                                  "; several inputs must be parts of one mesh with the same times (list the steps of a "
                                  "series in a .pvd or .series file)");
    }

    [[nodiscard]] std::string format() const override { return sources_[0]->format(); }
    [[nodiscard]] const std::vector<double>& times() const override { return sources_[0]->times(); }
    [[nodiscard]] vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) override {
        vtkNew<vtkMultiBlockDataSet> joined;
        counts_.clear();
        for (std::size_t i = 0; i < sources_.size(); ++i) {
            const auto data = sources_[i]->read(step, [&](double share) {
                progress((static_cast<double>(i) + share) / static_cast<double>(sources_.size()));
            });
            counts_.push_back(count_running(collect_input_grids(data).volumes));
            joined->SetBlock(static_cast<unsigned>(i), data);
            const std::string name = std::filesystem::path(inputs_[i]).stem().string();
            joined->GetMetaData(static_cast<unsigned>(i))->Set(vtkCompositeDataSet::NAME(), name.c_str());
        }
        return joined.Get();
    }
    [[nodiscard]] std::optional<std::vector<ArrayName>> listed_arrays(std::size_t step) const override {
        std::vector<ArrayName> all;
        for (const auto& source : sources_) {
            const auto listed = source->listed_arrays(step);
            if (!listed) return std::nullopt;
            all.insert(all.end(), listed->begin(), listed->end());
        }
        return all;
    }
    [[nodiscard]] std::map<std::string, std::string> units() const override { return sources_[0]->units(); }
    [[nodiscard]] std::string length_units() const override { return sources_[0]->length_units(); }
    [[nodiscard]] std::vector<std::string> notes() const override {
        return of_all([](const Source& source) { return source.notes(); });
    }
    [[nodiscard]] std::vector<std::string> lost() const override {
        return of_all([](const Source& source) { return source.lost(); });
    }
    [[nodiscard]] std::vector<std::filesystem::path> files_of(std::size_t step,
                                                              const std::set<std::string>& names) const override {
        std::vector<std::filesystem::path> all;
        for (const auto& source : sources_) {
            const std::vector<std::filesystem::path> files = source->files_of(step, names);
            if (files.empty()) return {};
            all.insert(all.end(), files.begin(), files.end());
        }
        return all;
    }
    void add_known(InputGrids& input_grids, const RunningCounts& first) const override {
        RunningCounts begin = first;
        for (std::size_t i = 0; i < sources_.size(); ++i) {
            sources_[i]->add_known(input_grids, begin);
            begin.points += counts_[i].points;
            begin.cells += counts_[i].cells;
        }
    }

private:
    template <typename Sentences>
    [[nodiscard]] std::vector<std::string> of_all(const Sentences& sentences_of) const {
        std::vector<std::string> all;
        for (const auto& source : sources_)
            for (std::string& sentence : sentences_of(*source)) all.push_back(std::move(sentence));
        return all;
    }

    std::vector<RunningCounts> counts_; // per input, for the step that was read last
    std::vector<std::unique_ptr<Source>> sources_;
    std::vector<std::string> inputs_;
};

} // namespace

std::unique_ptr<Source> open_source(const std::vector<std::string>& inputs, const SourceOptions& options) {
    for (const std::string& input : inputs) {
        require_existing(input);
        require_regular(input);
    }
    const Format& format = find_format(inputs.at(0));
    if (format.several_inputs || inputs.size() == 1) return format.open(inputs, options);
    std::vector<std::unique_ptr<Source>> sources;
    sources.reserve(inputs.size());
    for (const std::string& input : inputs) sources.push_back(open_source({input}, options));
    return std::make_unique<SeveralInputs>(std::move(sources), inputs);
}

} // namespace server::importer
