// LateFiles: the files of late arrays, which are read from the source of an import when a user needs them. They are in
// the dataset, or in a folder of their own if the dataset cannot be written to (store/README.md, "Late arrays").
#pragma once

#include "store/cache/stored_array.hpp"
#include "store/format/marker.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace server::store {

class LateFiles {
public:
    // `folder`: has the late files of all datasets that cannot be written to; an empty path: there is no such folder.
    LateFiles(std::filesystem::path dataset, const std::filesystem::path& folder, const std::string& dataset_id);

    // Returns `array`, with the directory in which the chunk lies: that of the dataset, or that in `folder`.
    [[nodiscard]] ArrayLayout layout_of(const ArrayLayout& array, std::uint64_t chunk) const;
    // Updates the late arrays of the step that have been written since the import. Removes arrays that the source does
    // not have at this step. `arrays`: layouts by array name. An array whose facts are damaged stays late.
    void complete(MarkedStep& step, const std::map<std::string, ArrayLayout>& arrays) const;
    // Returns a number that changes whenever late arrays have been written.
    [[nodiscard]] std::uint64_t changes() const;
    // Returns the directory in which this process writes late files: the dataset if it is writable, else elsewhere().
    // May not exist yet. Throws Error when the dataset is not writable and there is no folder.
    [[nodiscard]] std::filesystem::path writable() const;
    // Returns the directory of this dataset in `folder`; empty if there is no folder.
    [[nodiscard]] const std::filesystem::path& elsewhere() const { return elsewhere_; }
    // Writes the path of the dataset into elsewhere(), for remove_forgotten_late_files(). Throws Error on failure.
    void name_dataset() const;

private:
    [[nodiscard]] std::optional<MarkedArray> complete(const ArrayLayout& array, MarkedArray entry) const;
    [[nodiscard]] std::filesystem::path elsewhere(const std::filesystem::path& directory) const;

    std::filesystem::path dataset_, elsewhere_;
};

// Removes the late files of datasets that were removed or replaced. `folder`: see LateFiles. Files of datasets whose
// directory cannot be reached stay. Ignores errors: such files only take space.
void remove_forgotten_late_files(const std::filesystem::path& folder) noexcept;

} // namespace server::store
