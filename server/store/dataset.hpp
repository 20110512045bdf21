// A dataset on disk, opened for reading: NAME.ciel, a Zarr v2 group with raw chunks (store/README.md is the format).
#pragma once

#include "ciel/face_mesh.hpp"
#include "store/format/dataset_info.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ciel::store {

// What opening a dataset asks of the chunks of its steps. Whatever is chosen, a chunk is verified at first touch.
enum class Chunks {
    checked,  // each file's size; ranges that the commit marker lacks are made
    unchecked // nothing: for those who only add steps, however many there are
};

// Immutable view of what was committed when it was opened or last refreshed. Everything borrowed from it stays valid as
// long as the shared pointer lives: files are mapped, and are replaced, never truncated or rewritten, by writers. Who
// does so all the same is noticed: indices are checked where they are read, and check_intact says what was lost.
// Thread-safe.
class Dataset : public std::enable_shared_from_this<Dataset> {
public:
    // Throws Error naming the file when it is missing, damaged, truncated, of a newer version or not a dataset.
    // Topology checksums are verified here, chunks at first touch.
    [[nodiscard]] static std::shared_ptr<Dataset> open(const std::filesystem::path& directory,
                                                       Chunks chunks = Chunks::checked);
    virtual ~Dataset() = default;

    [[nodiscard]] virtual const std::filesystem::path& directory() const = 0; // as it was given to open()
    [[nodiscard]] virtual const DatasetInfo& info() const = 0;
    [[nodiscard]] virtual const std::vector<Step>& steps() const = 0;
    // The dataset with the steps committed since, or nullptr when there are none. Chunks stay mapped once. Looks at the
    // files of the new steps and at those that are mapped, not at those of the other steps.
    [[nodiscard]] virtual std::shared_ptr<Dataset> refreshed() const = 0;

    // Throws Error naming a file that was truncated while somebody read it, or that holds what it did not hold when it
    // was opened: whatever was made since is worthless. To be asked after the reading; costs next to nothing.
    virtual void check_intact() const = 0;
    [[nodiscard]] bool is_intact() const; // whether check_intact would not throw
    // As check_intact, and looks for files of the topology that were truncated or rewritten unnoticed. Examines each of
    // them.
    virtual void check_unchanged() const = 0;

    [[nodiscard]] virtual FaceMeshView mesh(std::size_t mesh, std::size_t coordinates) const = 0;
    [[nodiscard]] virtual std::vector<Group> groups(std::size_t mesh) const = 0;
    [[nodiscard]] virtual std::span<const Index> original_vertex(std::size_t mesh) const = 0;
    [[nodiscard]] virtual std::span<const Index> original_cell(std::size_t mesh) const = 0;
    // The numbers that the solver gave, -1 where it gave none; empty where the source has none. Never an index.
    [[nodiscard]] virtual std::span<const std::int64_t> solver_vertex(std::size_t mesh) const = 0;
    [[nodiscard]] virtual std::span<const std::int64_t> solver_cell(std::size_t mesh) const = 0;
    // components values per vertex, cell or boundary face, interleaved; empty when the array was not written at this
    // step. Throws Error for an unknown array or a damaged chunk.
    [[nodiscard]] virtual std::span<const float> values(const std::string& array, std::size_t step) const = 0;

    [[nodiscard]] const ArrayInfo* find(const std::string& array) const;
    [[nodiscard]] std::size_t step_at(double time) const; // the nearest step
};

// "U:x", "U:y", "U:z", "A:0", "R:xx", "U:magnitude" name one scalar of an array of several components; "p" names
// itself.
struct ScalarName {
    std::string array;
    std::optional<int> component; // none with magnitude = false: the array is a scalar itself
    bool magnitude = false;
};
// The length of a vector of two or three components, the Frobenius norm of a tensor; other arrays have none.
[[nodiscard]] bool has_magnitude(const ArrayInfo& array);
// tuple: the components of one item. no_value (no_value.hpp) where one of them is that.
[[nodiscard]] float scalar_of(const ArrayInfo& array, std::span<const float> tuple, const ScalarName& scalar);
[[nodiscard]] double magnitude_of(const ArrayInfo& array, std::span<const float> tuple);
// Throws Error with the names that exist when there is no such scalar.
[[nodiscard]] ScalarName parse_scalar(const Dataset& dataset, const std::string& name);
[[nodiscard]] std::vector<std::string> scalar_names(const ArrayInfo& array);
// The scalar of the cells that one of the points was made from, or `name` itself where it is of the cells; else empty.
[[nodiscard]] std::string cell_scalar(const Dataset& dataset, const std::string& name);

} // namespace ciel::store
