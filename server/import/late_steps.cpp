#include "import/late_steps.hpp"

#include "import/mesh/fingerprint.hpp"
#include "import/mesh/pieces.hpp"
#include "import/mesh/stored_mesh.hpp"
#include "import/progress.hpp"
#include "import/readers/open_source.hpp"
#include "import/source_facts.hpp"
#include "import/values/seam_difference.hpp"
#include "import/values/step_arrays.hpp"
#include "store/late_writer.hpp"
#include "store/mesh_arrays.hpp"
#include "store/valid_text.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iterator>
#include <numeric>

namespace server::importer {
namespace {

ComponentsOf components_of(const store::Dataset& dataset) {
    ComponentsOf components;
    for (const store::ArrayInfo& array : dataset.info().arrays) {
        FieldName field;
        field.components = array.components;
        field.component_names = array.component_names;
        components.emplace(array.name, components_text(field));
    }
    return components;
}

std::string at_time(const store::Dataset& dataset, std::size_t step) {
    std::string text = std::to_string(dataset.steps().times()[step]);
    while (text.ends_with('0')) text.pop_back();
    return "at time " + (text.ends_with('.') ? text + "0" : text);
}

class LateReader {
public:
    explicit LateReader(const LateOptions& options)
        : dataset_(store::Dataset::open(options.dataset, store::LackingRanges::left_out, std::nullopt, options.folder)),
          allow_bad_(options.allow_bad), facts_(dataset_->info().late),
          writer_(dataset_, options.folder, [] { progress(0, "waiting"); }), selection_(facts_.arrays()) {
        facts_.set_arrays(dataset_->info().arrays);
    }

    void run(std::vector<std::size_t> steps) {
        for (const std::size_t step : steps) (void)dataset_->steps().at(step); // throws if there is no such step
        std::erase_if(steps, [&](std::size_t step) { return !writer_.lacks(step); });
        std::vector<std::string> problems;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            first_ = static_cast<double>(i) / static_cast<double>(steps.size());
            share_ = 1 / static_cast<double>(steps.size());
            try {
                read(steps[i]);
            } catch (const ciel::Error& error) {
                problems.push_back(naming_source(error.what()));
            } catch (const std::filesystem::filesystem_error& error) {
                problems.push_back(naming_source("cannot be read: " + error.code().message()));
            }
        }
        writer_.tell_readers();
        if (problems.empty()) return;
        throw ciel::Error(problems.front() + (problems.size() > 1
                                                  ? " (" + std::to_string(problems.size()) + " steps could not be read)"
                                                  : ""));
    }
    [[nodiscard]] std::vector<std::size_t> all_steps() const {
        std::vector<std::size_t> steps(dataset_->steps().size());
        std::iota(steps.begin(), steps.end(), std::size_t{0});
        return steps;
    }

private:
    void tell(double of_step, const std::string& what, std::size_t step) const {
        progress(0.99 * (first_ + share_ * of_step), what + ", step " + std::to_string(step));
    }

    void open() {
        if (source_) return;
        facts_.check_inputs();
        source_ = open_source(facts_.inputs(), facts_.source_options());
        arrays_.emplace(selection_, *source_, FieldComponents(components_of(*dataset_)), writer_.directory());
    }

    [[nodiscard]] std::size_t step_of_source(std::size_t step) const {
        const std::vector<double>& times = source_->times();
        const auto found = std::ranges::find(times, dataset_->steps().times()[step]);
        if (found == times.end())
            throw ciel::Error("has no step " + at_time(*dataset_, step) + " any more; import it again with --force");
        return static_cast<std::size_t>(found - times.begin());
    }

    void read(std::size_t step) {
        tell(0, "opening", step);
        open();
        const std::size_t of_source = step_of_source(step);
        const std::string state = facts_.state_of(*source_, of_source), known = facts_.state_at_import(step);
        if (!known.empty() && state != known) refuse_change(step);
        const auto reading = [&](double share) { tell(0.5 * share, "reading", step); };
        InputGrids input_grids = collect_input_grids(source_->read(of_source, reading));
        source_->add_known(input_grids, {});
        require_volumes(input_grids);
        tell(0.5, "matching the mesh", step);
        match_mesh(input_grids, step);
        tell(0.7, "making arrays", step);
        const auto topology = [this]() -> const ciel::Topology& { return topology_of_mesh(); };
        const std::vector<std::string> lost_before = arrays_->lost();
        CollectedArrays collected; // written only after check_whole
        arrays_->make(of_source, mesh_, input_grids, topology, point_maker_,
                      std::bind_front(&CollectedArrays::add, &collected));
        check_whole(step, lost_before);
        if (facts_.state_of(*source_, of_source) != state) refuse_change(step); // changed while it was read
        tell(0.9, "writing", step);
        for (const store::ArrayValues& array : collected.arrays()) {
            const store::ArrayValues named{store::with_valid_text(array.info), array.values};
            if (dataset_->find(named.info.name) != nullptr)
                writer_.put(step, named);
            else
                std::printf("note The array %s %s is not in the dataset and was left out.\n", named.info.name.c_str(),
                            at_time(*dataset_, step).c_str());
        }
        writer_.end_step(step);
        std::printf("step %zu\n", step);
        std::fflush(stdout);
    }

    // Throws Error if data of the step was lost, because a step that has been written is never read again.
    // `lost_before`: arrays that were lost at the steps before, sorted.
    void check_whole(std::size_t step, const std::vector<std::string>& lost_before) const {
        std::vector<std::string> lost = source_->lost();
        std::ranges::set_difference(arrays_->lost(), lost_before, std::back_inserter(lost));
        if (lost.empty() || allow_bad_) return;
        throw ciel::Error("cannot be read whole " + at_time(*dataset_, step) + ": " + lost.front() +
                          " --allow-bad accepts the loss");
    }

    const ciel::Topology& topology_of_mesh() {
        if (!topology_) topology_ = dataset_->topology(0);
        return *topology_;
    }

    [[noreturn]] void refuse_mesh(std::size_t step) const {
        throw ciel::Error("has another mesh " + at_time(*dataset_, step) +
                          " than at its first step; import it again with --all --force");
    }

    [[noreturn]] void refuse_change(std::size_t step) const {
        throw ciel::Error("has changed " + at_time(*dataset_, step) +
                          " since it was imported; import it again with --force");
    }

    // Adds the path of the source, because some sentences do not name it.
    [[nodiscard]] std::string naming_source(const std::string& sentence) const {
        if (facts_.inputs().empty()) return sentence;
        const std::string& source = facts_.inputs().front();
        return sentence.find(source) != std::string::npos ? sentence : source + ": " + sentence;
    }

    // Sets mesh_ to the mesh of the step, with the ids of the dataset.
    void match_mesh(const InputGrids& input_grids, std::size_t step) {
        const Fingerprint print = fingerprint(input_grids);
        if (mesh_.point_count > 0 && print.text() == print_.text()) {
            update_step_mesh(mesh_, input_grids, false);
            if (!difference_across(mesh_.seams, mesh_.members).empty() ||
                !still_the_same(mesh_.joined_pieces, mesh_.members))
                refuse_mesh(step);
            return;
        }
        auto mesh = facts_.has_stored_mesh(print) ? stored_mesh(*dataset_, input_grids) : std::nullopt;
        if (!mesh) mesh = matched_mesh(input_grids, step);
        mesh_ = std::move(*mesh);
        print_ = print;
        point_maker_.reset();
    }

    [[nodiscard]] StepMesh matched_mesh(const InputGrids& input_grids, std::size_t step) const {
        StepMesh mesh = build_step_mesh(input_grids, facts_.weld(), difference_across, writer_.directory());
        mesh.cells.reset();
        const ciel::FaceMeshView stored = dataset_->mesh_arrays().points(0, 0);
        if (!std::ranges::equal(mesh.point_of_vertex, dataset_->original_vertex(0)) ||
            !std::ranges::equal(mesh.cell_of_cell, dataset_->original_cell(0)) ||
            !std::ranges::equal(mesh.positions.bytes(), stored.positions.bytes()))
            refuse_mesh(step);
        mesh.positions = store::Values(stored.positions, stored.keep_alive);
        return mesh;
    }

    std::shared_ptr<store::Dataset> dataset_;
    const bool allow_bad_;
    SourceFacts facts_;
    store::LateWriter writer_;
    ArraySelection selection_;
    std::unique_ptr<Source> source_;
    std::optional<StepArrays> arrays_;
    StepMesh mesh_;
    Fingerprint print_;
    std::optional<ciel::Topology> topology_;
    std::unique_ptr<PointMaker> point_maker_;
    double first_ = 0, share_ = 1;
};

} // namespace

void read_late_steps(const LateOptions& options) {
    LateReader reader(options);
    reader.run(options.steps.empty() ? reader.all_steps() : options.steps);
}

} // namespace server::importer
