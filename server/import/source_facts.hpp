// What a dataset remembers of its import, so that late steps can be read from the same source in the same way.
#pragma once

#include "import/convert.hpp"
#include "import/mesh/fingerprint.hpp"
#include "import/mesh/step_mesh.hpp"
#include "store/format/dataset_info.hpp"

#include <set>
#include <span>

namespace server::importer {

class SourceFacts {
public:
    explicit SourceFacts(store::LateSource source) : source_(std::move(source)) {}
    // Facts of an import that begins now.
    explicit SourceFacts(const Options& options);

    [[nodiscard]] const store::LateSource& stored() const { return source_; }
    [[nodiscard]] const std::vector<std::string>& inputs() const { return source_.inputs; }
    [[nodiscard]] std::vector<std::string> arrays() const;
    [[nodiscard]] Weld weld() const;
    [[nodiscard]] SourceOptions source_options() const;
    // Throws Error if an input is missing.
    void check_inputs() const;
    // Returns a text that changes with the names, sizes and times of the files of a step. If these files are not known,
    // the text changes with the inputs (importing/freshness.hpp).
    [[nodiscard]] std::string state_of(const Source& source, std::size_t step_of_source) const;
    // Returns what state_of() returned at the import; empty if files of the step were missing then.
    [[nodiscard]] std::string state_at_import(std::size_t step_of_dataset) const;
    // `print`: fingerprint of a step. Returns whether the step has the mesh of the dataset, so that stored_mesh() may
    // be called.
    [[nodiscard]] bool has_stored_mesh(const Fingerprint& print) const { return source_.mesh == print.text(); }

    // Call this before functions that examine files of steps. If the format has a file for each array, only the files
    // of these arrays are examined. A field that is added to the source later is then no change.
    void set_arrays(std::span<const store::ArrayInfo> arrays);
    void set_mesh(const StepMesh& mesh, const Fingerprint& print) {
        if (mesh.may_be_stored_mesh) source_.mesh = print.text();
    }
    // Call one of these functions for each step of the dataset, in the order of the steps.
    void add_written_step() { source_.files.emplace_back(); }
    void add_late_step(const Source& source, std::size_t step_of_source);
    // Returns false if a path cannot be stored, because it is not UTF-8.
    [[nodiscard]] bool can_be_stored() const;
    // Returns false if the files of a step are not known and an input has changed since the import began.
    [[nodiscard]] bool is_current(const Source& source) const;

private:
    [[nodiscard]] bool has_files() const; // whether the files of at least one step are known

    store::LateSource source_;
    std::set<std::string> names_; // names of array files
};

} // namespace server::importer
