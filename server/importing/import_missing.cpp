#include "importing/import_missing.hpp"

#include "ciel/types.hpp"
#include "importing/freshness.hpp"
#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/format/layout.hpp"
#include "store/imported_copy.hpp"

#include <span>

namespace server::importing {
namespace {

namespace fs = std::filesystem;
constexpr const char* extension = ".ciel";

bool is_dataset(const fs::path& path) { return fs::exists(path / store::layout::commit_marker); }

bool is_folder_of_datasets(const fs::path& path) { return fs::is_directory(path) && !is_openfoam_case(path); }

fs::path without_slash(const fs::path& path) {
    const fs::path whole = fs::absolute(path).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

// Returns "run" for "run.vtu" and "run.vtu.series". The name of a directory has no extension.
std::string dataset_name(const fs::path& input) {
    if (fs::is_directory(input)) return input.filename().string();
    fs::path name = input.stem();
    if (input.extension() == ".series") name = name.stem();
    return name.string();
}

// The target contains a checksum of the input's path, so that inputs with the same name have different targets.
fs::path target_of(const fs::path& input, const fs::path& folder) {
    const std::string path = fs::weakly_canonical(input).string();
    const std::string sum = store::checksum(std::as_bytes(std::span(path)));
    return without_slash(folder) / sum.substr(sum.find(':') + 1) / (dataset_name(input) + extension);
}

// import_one() sets the time of the commit marker to the time of the input's last change.
bool is_imported(const fs::path& input, const fs::path& target) {
    return is_dataset(target) && fs::last_write_time(target / store::layout::commit_marker) >= last_change(input);
}

// Marks a copy that an earlier version of CIEL made without a mark. Ignores errors: the mark only makes writers refuse
// to append, and a copy that cannot be written cannot be appended to.
void complete_sign(const fs::path& input, const fs::path& target) {
    try {
        store::mark_as_copy(target, input);
    } catch (const ciel::Error&) {
        return;
    }
}

// Returns the error sentence of the import; empty on success.
std::string import_one(const fs::path& input, const fs::path& target, const ImportLimits& limits,
                       const ImportListener& listener, const std::atomic<bool>& cancel) {
    try {
        store::make_directory(target.parent_path());
    } catch (const ciel::Error& error) {
        return error.what();
    }
    listener.line("importing " + input.string());
    const auto imported = last_change(input); // read before the import, because the import may miss later changes
    const ImportValues values{{"inputs", {input.string()}}, {"output", {target.string()}}, {"force", {"yes"}}};
    const ImportEnd end = run_import(values, limits, listener, cancel);
    if (!end.is_written && (end.exit_code == 1 || end.exit_code == 2)) {
        std::error_code error;
        fs::remove(target.parent_path(), error); // removes the folder only if it is empty
        if (cancel) throw ciel::Error(end.problem);
        return end.problem;
    }
    fs::last_write_time(target / store::layout::commit_marker, imported);
    store::mark_as_copy(target, input);
    if (!end.problem.empty()) listener.line(end.problem);
    return {};
}

} // namespace

std::vector<Servable> import_missing(const std::vector<fs::path>& data, const fs::path& folder,
                                     const ImportLimits& limits, const ImportListener& listener,
                                     const std::atomic<bool>& cancel) {
    for (const fs::path& path : data)
        if (!fs::exists(path))
            throw ciel::Error(path.string() +
                              " does not exist; name a dataset, a folder of datasets or a file to import");
    std::vector<Servable> result;
    for (const fs::path& path : data) {
        const fs::path input = without_slash(path);
        if (input.extension() == extension || is_folder_of_datasets(input)) {
            result.push_back({input, {}, {}});
            continue;
        }
        const fs::path target = target_of(input, folder);
        const bool is_there = is_imported(input, target);
        result.push_back({target, input, is_there ? "" : import_one(input, target, limits, listener, cancel)});
        if (is_there && store::input_of_copy(target).empty()) complete_sign(input, target);
    }
    return result;
}

} // namespace server::importing
