#include "import/convert.hpp"

#include "import/mesh/fingerprint.hpp"
#include "import/progress.hpp"
#include "import/source_facts.hpp"
#include "import/values/seam_difference.hpp"
#include "import/values/solver_ids.hpp"
#include "import/values/step_arrays.hpp"
#include "limits/peak_memory.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <malloc.h>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace server::importer {

namespace {

class Converter {
public:
    Converter(Source& source, const Options& options, ComponentsOf components)
        : source_(source), options_(options), facts_(options), selection_(options.arrays),
          folder_(std::filesystem::absolute(options.output).parent_path()),
          arrays_(selection_, source, FieldComponents(std::move(components)), folder_) {}

    // Returns nullopt and writes no dataset if most steps have other components of an array than FieldComponents chose.
    std::optional<ConvertResult> run() {
        const std::vector<double>& times = source_.times();
        check_listing();
        add_step(times[0]);
        finished_steps_ = 1;
        step_ = leave_steps_late() ? times.size() : 1;
        for (; step_ < times.size(); ++step_) {
            finished_steps_ = step_;
            add_step(times[step_]);
        }
        finished_steps_ = times.size();
        if (!writer_) throw ciel::Error(first_reason_);
        selection_.check();
        if (!arrays_.components().is_of_most_steps()) return std::nullopt;
        for (const std::string& sentence : arrays_.notes()) note(sentence);
        for (const std::string& sentence : arrays_.lost()) lose(sentence);
        tell(1.0, "finishing");
        writer_->finish();
        return std::move(result_);
    }
    [[nodiscard]] ComponentsOf components() const { return arrays_.components().of_most_steps(); }

private:
    // `phase_share`: finished share of the current step, in [0, 1].
    void tell(double phase_share, const std::string& what) const {
        const auto steps = static_cast<double>(source_.times().size());
        const double done = std::min((static_cast<double>(finished_steps_) + phase_share) / steps, 1.0);
        std::string phase = what;
        if (steps > 1 && static_cast<double>(step_) < steps)
            phase.append(", step ")
                .append(std::to_string(step_ + 1))
                .append(" of ")
                .append(std::to_string(source_.times().size()));
        progress(0.98 * done, phase);
    }

    // Finds an unknown --array before any data is read, if the reader can list its arrays.
    void check_listing() {
        for (std::size_t step = 0; step < source_.times().size() && !selection_.complete(); ++step) {
            std::optional<std::vector<ArrayName>> listed;
            try {
                listed = source_.listed_arrays(step);
            } catch (const ciel::Error&) { // add_step() reports the error when it reads the step
                return;
            }
            if (!listed) return;
            for (const ArrayName& array : *listed) selection_.saw(array);
        }
        selection_.check();
    }

    // Finds an unknown --array, but not if there are several steps, because a later step could have the array.
    void check_only_step(const InputGrids& input_grids) {
        if (source_.times().size() > 1) return;
        for (const FieldName& field : field_names(input_grids)) selection_.saw(field);
        selection_.check();
    }

    bool is_new_time(double time) {
        if (!std::isfinite(time))
            throw ciel::Error("the time of step " + std::to_string(step_) +
                              " is not a finite number; correct it in the input");
        if (last_time_ && time <= *last_time_) {
            note("A second step at time " + std::to_string(time) + " was left out.");
            return false;
        }
        last_time_ = time;
        return true;
    }

    InputGrids read_step() {
        InputGrids input_grids =
            collect_input_grids(source_.read(step_, [this](double share) { tell(0.5 * share, "reading"); }));
        source_.add_known(input_grids, {});
        require_volumes(input_grids);
        return input_grids;
    }

    void make_arrays(const InputGrids& input_grids, const ArraySink& sink) {
        tell(0.8, "making arrays");
        const auto topology = [this]() -> const ciel::Topology& { return writer_->topology(mesh_index_); };
        const auto know = [&](store::ArrayInfo info, store::Values values) {
            info.doubles = values.has_doubles();
            known_arrays_.try_emplace(info.name, info);
            sink(info, std::move(values));
        };
        arrays_.make(step_, mesh_, input_grids, topology, point_maker_, know);
    }

    // Returns whether some steps between the first and the last one list an array that would not be in the dataset.
    bool has_more_arrays_between() {
        constexpr std::size_t most_listed = 16;
        const std::size_t last = source_.times().size() - 1;
        std::set<std::pair<FieldOf, std::string>> known;
        const auto has_unknown = [&](std::size_t step) {
            bool found = false;
            for (const ArrayName& array : source_.listed_arrays(step).value_or(std::vector<ArrayName>()))
                found |= known.emplace(array.of, array.name).second;
            return found;
        };
        try {
            (void)has_unknown(0);
            (void)has_unknown(last);
            for (std::size_t step = 1; step < last; step += std::max<std::size_t>(last / most_listed, 1))
                if (has_unknown(step)) return true;
        } catch (const ciel::Error&) { // a file is missing; the error is told when its step is read
        }
        return false;
    }

    // Also called for the middle step, because a mesh may move and be back at its first positions at the last step.
    bool has_mesh_of_first(const InputGrids& input_grids) const {
        const Fingerprint print = fingerprint(input_grids);
        return print.cells == print_.cells && print.positions == print_.positions;
    }

    // Reads the middle and the last step. If both have the mesh of the first step, adds the steps in between as late
    // steps, adds the last step, and returns true. Otherwise returns false: the caller reads all steps after the first.
    bool leave_steps_late() {
        const std::vector<double>& times = source_.times();
        if (options_.all || times.size() < 3 || !writer_ || !(selection_.complete() || options_.arrays.empty()) ||
            !facts_.can_be_stored() || has_more_arrays_between())
            return false;
        step_ = times.size() / 2;
        try {
            if (!has_mesh_of_first(read_step())) return false;
        } catch (const ciel::Error&) { // the error is told when the step is read
        }
        step_ = times.size() - 1;
        InputGrids input_grids;
        try {
            input_grids = read_step();
        } catch (const ciel::Error&) { // add_step() reports the error
            return false;
        }
        if (!has_mesh_of_first(input_grids)) return false;
        update_step_mesh(mesh_, input_grids, false);
        if (!difference_across(mesh_.seams, mesh_.members).empty()) return false;
        if (!still_the_same(mesh_.joined_pieces, mesh_.members) || !facts_.is_current(source_)) return false;
        SourceFacts facts = facts_;
        for (const std::string& sentence : source_.lost()) lose(sentence);
        CollectedArrays collected; // written after the late steps, whose times are earlier
        make_arrays(input_grids, std::bind_front(&CollectedArrays::add, &collected));
        std::vector<store::ArrayInfo> infos;
        for (const auto& [name, info] : known_arrays_) infos.push_back(info);
        facts.set_arrays(infos);
        facts.set_mesh(mesh_, print_);
        facts.add_written_step();
        for (step_ = 1; step_ + 1 < times.size(); ++step_) {
            finished_steps_ = step_;
            tell(0, "listing files");
            if (!is_new_time(times[step_])) continue;
            writer_->add_late_step(times[step_], mesh_index_, coordinates_index_, infos);
            facts.add_late_step(source_, step_);
            ++result_.late_steps;
        }
        tell(0.9, "writing");
        if (is_new_time(times[step_])) {
            writer_->add_step(times[step_], mesh_index_, coordinates_index_, collected.arrays());
            facts.add_written_step();
        }
        if (result_.late_steps > 0) writer_->set_late(facts.stored());
        return true;
    }

    void add_step(double time) {
        if (!is_new_time(time)) return;
        InputGrids input_grids;
        try {
            input_grids = read_step();
        } catch (const ciel::Error& error) {
            return lose_step(time, error.what());
        }
        for (const std::string& sentence : source_.lost()) lose(sentence);
        check_only_step(input_grids);
        const std::uint64_t of_reader = peak_memory_.restart();
        const Fingerprint print = fingerprint(input_grids);
        const bool is_same =
            writer_ && print.cells == print_.cells && same_mesh(input_grids, print.positions != print_.positions, time);
        if (!is_same && !new_mesh(input_grids, time)) return;
        print_ = print;
        writer_->begin_step(time, mesh_index_, coordinates_index_);
        make_arrays(input_grids, [this](const store::ArrayInfo& info, const store::Values& values) {
            writer_->add_values({info, values});
        });
        writer_->end_step();
        const std::uint64_t beyond = peak_memory_.bytes() - of_reader;
        if (beyond > result_.memory.beyond) result_.memory = {of_reader, beyond, mesh_.input_cells};
    }

    // Returns false, and does not change mesh_, if the mesh cannot be built.
    bool new_mesh(const InputGrids& input_grids, double time) {
        tell(0.5, "building the mesh");
        try {
            mesh_ = build_step_mesh(input_grids, options_.weld, difference_across, folder_);
        } catch (const ciel::Error& error) {
            lose_step(time, error.what());
            return false;
        }
        point_maker_.reset();
        result_.cells += mesh_.input_cells;
        result_.bad_cells += mesh_.bad_cells;
        if (!writer_) make_writer();
        for (const std::string& sentence : mesh_.notes) note(sentence);
        tell(0.7, "writing the mesh");
        const auto vertices = to_stored(gather_solver_ids(mesh_.members, FieldOf::points), mesh_.point_of_vertex);
        const auto cells = to_stored(gather_solver_ids(mesh_.members, FieldOf::cells), mesh_.cell_of_cell);
        mesh_.positions = {}; // not needed while the blocks are built
        mesh_index_ = writer_->add_mesh(mesh_.cells->matched, mesh_.boundary, mesh_.point_of_vertex, mesh_.cell_of_cell,
                                        mesh_.groups, {vertices, cells});
        mesh_.cells.reset();
        ::malloc_trim(0); // otherwise malloc keeps the freed memory of the blocks
        coordinates_index_ = 0;
        mesh_.positions = writer_->positions(mesh_index_, coordinates_index_);
        return true;
    }

    // Returns false if the step needs a new mesh.
    bool same_mesh(const InputGrids& input_grids, bool moved, double time) {
        update_step_mesh(mesh_, input_grids, moved);
        if (const std::string what = difference_across(mesh_.seams, mesh_.members); !what.empty()) {
            std::ostringstream sentence;
            sentence << "From time " << time << " on " << what
                     << " differs across a seam that was welded at earlier times; from that time on the dataset has "
                        "another mesh.";
            note(sentence.str());
            print_ = {}; // mesh_ no longer has the positions that are in the dataset
            return false;
        }
        if (!still_the_same(mesh_.joined_pieces, mesh_.members)) {
            std::ostringstream sentence;
            sentence << "From time " << time
                     << " on, points of two pieces differ that were welded at earlier times; from that time on the "
                        "dataset has another mesh.";
            note(sentence.str());
            print_ = {};
            return false;
        }
        if (!moved) return true;
        const ciel::ValuesView positions = mesh_.view().positions;
        if (!writer_->holds(mesh_index_, positions)) { // positions need doubles, but the dataset has floats
            print_ = {};
            return false;
        }
        point_maker_.reset();
        coordinates_index_ = writer_->add_coordinates(mesh_index_, positions);
        mesh_.positions = writer_->positions(mesh_index_, coordinates_index_);
        return true;
    }

    void lose_step(double time, const std::string& reason) {
        if (first_reason_.empty()) first_reason_ = reason;
        std::ostringstream sentence;
        sentence << "The step at time " << time << " could not be read and was left out: " << reason;
        lose(sentence.str());
    }

    void lose(const std::string& sentence) {
        if (!noted_.contains(sentence)) result_.lost.push_back(sentence);
        note(sentence);
    }

    void make_writer() {
        store::DatasetHeader header;
        header.source = source_.format() + ":";
        for (const std::string& input : options_.inputs) {
            auto path = std::filesystem::absolute(input).lexically_normal();
            if (!path.has_filename()) path = path.parent_path();
            header.source.append(" ").append(path.filename().string());
        }
        header.length_units = source_.length_units();
        header.input_vertices = mesh_.input_vertices;
        header.input_edges = mesh_.input_edges;
        header.input_cells = mesh_.input_cells;
        writer_.emplace(options_.output, header, options_.force);
        for (const std::string& sentence : result_.notes) writer_->add_note(sentence);
        for (const std::string& sentence : source_.notes()) note(sentence);
    }

    void note(const std::string& sentence) {
        if (!noted_.insert(sentence).second) return;
        result_.notes.push_back(sentence);
        if (writer_) writer_->add_note(sentence);
    }

    Source& source_;
    const Options& options_;
    const SourceFacts facts_; // made before the source is read, so that a later change is noticed
    ArraySelection selection_;
    const std::filesystem::path folder_; // of large temporary files
    StepArrays arrays_;
    std::optional<store::Writer> writer_;
    StepMesh mesh_;
    std::unique_ptr<PointMaker> point_maker_;
    std::map<std::string, store::ArrayInfo> known_arrays_; // by name
    Fingerprint print_;
    std::size_t step_ = 0, mesh_index_ = 0, coordinates_index_ = 0;
    std::size_t finished_steps_ = 0; // for the progress; step_ is ahead while steps are only compared
    std::optional<double> last_time_;
    std::string first_reason_; // error of the first lost step
    std::set<std::string> noted_;
    ConvertResult result_;
    limits::PeakMemory peak_memory_;
};

} // namespace

ConvertResult convert(Source& source, const Options& options) {
    ComponentsOf components;
    while (true) {
        Converter converter(source, options, components);
        if (auto result = converter.run()) return std::move(*result);
        components = converter.components(); // the second run succeeds, because most steps have these components
    }
}

} // namespace server::importer
