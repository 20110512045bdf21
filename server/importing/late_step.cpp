#include "importing/late_step.hpp"

#include "importing/without_folder.hpp"
#include "store/files/files.hpp"

#include <chrono>
#include <thread>
#include <utility>

namespace server::importing {
namespace {

constexpr std::chrono::milliseconds pause_when_read{200};

} // namespace

std::string read_late_step(const store::Dataset& dataset, std::size_t step, const std::filesystem::path& folder,
                           const ImportLimits& limits, const std::atomic<bool>& cancel) {
    try {
        // Another process has written the arrays. Waits, so that this process notices them before its views are told.
        if (dataset.late_chunks(step).empty()) {
            std::this_thread::sleep_for(pause_when_read);
            return {};
        }
        ImportValues values{{"inputs", {dataset.directory().string()}}, {"step", {std::to_string(step)}}};
        if (!folder.empty()) values["late-folder"] = {folder.string()};
        const ImportListener silent{[](double, const std::string&) {}, [](const std::string&) {}};
        std::string problem = run_import(values, limits, silent, cancel).problem;
        for (const std::filesystem::path& known : {folder / "", dataset.directory()})
            problem = without_folder(std::move(problem), known.parent_path());
        for (const std::string& input : dataset.info().late.inputs)
            problem = without_folder(std::move(problem), std::filesystem::path(input).parent_path());
        return problem;
    } catch (const std::exception& error) {
        return store::sentence_for_clients(error);
    }
}

} // namespace server::importing
