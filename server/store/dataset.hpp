// Dataset: NAME.ciel, a Zarr v2 group with raw chunks, opened for reading (format: store/README.md).
#pragma once

#include "ciel/block_ranges.hpp"
#include "ciel/topology.hpp"
#include "store/files/local_files.hpp"
#include "store/format/histogram.hpp"
#include "store/format/steps.hpp"
#include "store/format/values.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace server::store {

class MeshArrays;    // mesh_arrays.hpp
struct ValuesToLoad; // cache/checked_file.hpp

// What Dataset::open does if the commit marker has no ranges, as for steps that were appended with plain Zarr.
enum class LackingRanges {
    computed, // reads the chunks of these arrays and computes their ranges
    left_out  // leaves the ranges empty; for writers that append to a dataset
};

// The parsed name of a scalar. A scalar is a component ("U:x", "A:0", "R:xx") or the magnitude ("U:magnitude") of an
// array, or an array of one component ("p").
struct ScalarName {
    std::string array;
    std::optional<int> component; // nullopt for a magnitude and for an array of one component
    bool magnitude = false;

    [[nodiscard]] bool operator==(const ScalarName&) const = default;
};

// An immutable view of the steps that were committed when the dataset was opened or refreshed. Its spans and mesh views
// are valid as long as it exists. Files are mapped. Therefore writers must replace files instead of truncating or
// rewriting them. After such a change, reads do not crash, and check_intact throws. Thread-safe.
class Dataset : public std::enable_shared_from_this<Dataset> {
public:
    // Throws Error that names the file when a file is missing, damaged, truncated or of a newer version. Arrays,
    // records, and steps in the table of steps are read and verified when they are first used. `access`: how records,
    // values and positions are read; nullopt: access_to(directory). The numbered faces (mesh_arrays.hpp) are always
    // mapped. `late_folder`: see LateFiles (late_files.hpp).
    [[nodiscard]] static std::shared_ptr<Dataset> open(const std::filesystem::path& directory,
                                                       LackingRanges lacking = LackingRanges::computed,
                                                       std::optional<FileAccess> access = std::nullopt,
                                                       const std::filesystem::path& late_folder = {});
    virtual ~Dataset() = default;

    [[nodiscard]] virtual const std::filesystem::path& directory() const = 0; // as given to open()
    [[nodiscard]] virtual const DatasetInfo& info() const = 0;
    [[nodiscard]] virtual const Steps& steps() const = 0;
    // Returns a Dataset that also has the steps and the late arrays that were written since; nullptr if there are none.
    // Both objects share the mapped files. Throws Error when a file is damaged, or when the dataset was replaced by
    // another dataset.
    [[nodiscard]] virtual std::shared_ptr<Dataset> refreshed() const = 0;

    // Throws Error if a mapped file was found to be truncated or rewritten. Call it after reading. If it throws,
    // discard the results made from the dataset. Costs one atomic read if no mapping is lost.
    virtual void check_intact() const = 0;
    [[nodiscard]] bool is_intact() const; // false if check_intact would throw
    // Reads all files. Throws Error that names the first damaged file.
    virtual void verify() const = 0;
    // Like check_intact, but first calls stat for each topology file to detect changes.
    virtual void check_unchanged() const = 0;
    // Returns read(). The kernel's error about a record that changed names no file. If read() throws Error and a
    // topology file has changed, throws the error of check_unchanged, which names the file.
    template <typename Read>
    auto naming_changed_file(const Read& read) const {
        try {
            return read();
        } catch (const ciel::Error&) {
            check_unchanged();
            throw;
        }
    }

    // Size of copied values and positions; 0 with FileAccess::mapped.
    [[nodiscard]] virtual std::size_t memory_bytes() const = 0;

    [[nodiscard]] virtual const MeshArrays& mesh_arrays() const = 0; // positions and faces
    // The topology keeps the files of records open, and reads a record when the record is first used.
    [[nodiscard]] virtual ciel::Topology topology(std::size_t mesh) const = 0;
    [[nodiscard]] virtual std::vector<Group> groups(std::size_t mesh) const = 0;
    // Return for each vertex or cell of the dataset its id in the imported file.
    [[nodiscard]] virtual std::span<const ciel::Index> original_vertex(std::size_t mesh) const = 0;
    [[nodiscard]] virtual std::span<const ciel::Index> original_cell(std::size_t mesh) const = 0;
    // An id of -1 means that the solver gave no id. Empty if the imported file has none. A solver id must not be used
    // as an index.
    [[nodiscard]] virtual std::span<const std::int64_t> solver_vertex(std::size_t mesh) const = 0;
    [[nodiscard]] virtual std::span<const std::int64_t> solver_cell(std::size_t mesh) const = 0;
    // Return one id; nullopt if the solver gave none. Each call reads only the 64 KiB of the file that have the id.
    // REQUIRES: the vertex or cell exists.
    [[nodiscard]] virtual ciel::Index original_vertex(std::size_t mesh, ciel::Index vertex) const = 0;
    [[nodiscard]] virtual ciel::Index original_cell(std::size_t mesh, ciel::Index cell) const = 0;
    [[nodiscard]] virtual std::optional<std::int64_t> solver_vertex(std::size_t mesh, ciel::Index vertex) const = 0;
    [[nodiscard]] virtual std::optional<std::int64_t> solver_cell(std::size_t mesh, ciel::Index cell) const = 0;
    // Returns `components` numbers for each vertex, cell or boundary face, interleaved. Empty if the array was not
    // written at this step. Throws Error for an unknown array, an array that is still to be read from its source, or a
    // damaged chunk.
    [[nodiscard]] virtual Values values(const std::string& array, std::size_t step) const = 0;
    // Like values, but reads nothing yet. Before the caller uses values, it must load them with CheckedFile::load,
    // which reads them and verifies their checksums.
    [[nodiscard]] virtual ValuesToLoad values_to_load(const std::string& array, std::size_t step) const = 0;

    // Returns the late arrays (late_files.hpp) of a step that have not been written yet, with the numbers of their
    // chunks. Reads the disk at each call.
    [[nodiscard]] virtual std::map<std::string, std::uint64_t> late_chunks(std::size_t step) const = 0;

    // Returns the range of the scalar in each block; nullopt if no ranges are stored or the scalar is not on points.
    // Throws Error when the ranges are damaged.
    [[nodiscard]] virtual std::optional<ciel::BlockRanges> block_ranges(const ScalarName& scalar,
                                                                        std::size_t step) const = 0;

    // Returns the stored histogram of a scalar. It has stored_bins bins over the range of the finite values. Returns
    // nullopt if no histogram is stored. Throws Error when the histogram is damaged.
    [[nodiscard]] virtual std::optional<Histogram> histogram(const ScalarName& scalar, std::size_t step) const = 0;

    // Returns, for each block, the bounding box of its vertices; nullopt if no boxes are stored.
    [[nodiscard]] virtual std::optional<ciel::BlockBoxes> block_boxes(std::size_t mesh,
                                                                      std::size_t coordinates) const = 0;

    [[nodiscard]] const ArrayInfo* find(const std::string& array) const;
    [[nodiscard]] std::size_t step_at(double time) const; // index of the step whose time is nearest
};

// Returns whether the array has a magnitude. The magnitude of a vector of two or three components is its length. The
// magnitude of a tensor (an array with component names) is its Frobenius norm.
[[nodiscard]] bool has_magnitude(const ArrayInfo& array);
// tuple: the components of one vertex, cell or boundary face.
[[nodiscard]] double magnitude_of(const ArrayInfo& array, ciel::ValuesView tuple);
// Sets out[i] to the scalar of tuple i. `tuples`: components, interleaved. A magnitude is no_value (no_value.hpp) if
// one of the components is no_value.
void scalars_in(const ArrayInfo& array, std::span<const float> tuples, const ScalarName& scalar, std::span<float> out);
void scalars_in(const ArrayInfo& array, std::span<const double> tuples, const ScalarName& scalar,
                std::span<double> out);
// Returns the scalar of each tuple, in the type of `values`.
[[nodiscard]] Values one_scalar(const ArrayInfo& array, ciel::ValuesView values, const ScalarName& scalar);
// Returns all scalars of the array: its magnitude, if it has one, then its components. scalar_names has this order,
// too.
[[nodiscard]] std::vector<ScalarName> scalars_of(const ArrayInfo& array);
// Parses the name of a scalar. Throws Error that lists the existing names when there is no scalar `name`.
[[nodiscard]] ScalarName parse_scalar(const Dataset& dataset, const std::string& name);
[[nodiscard]] std::vector<std::string> scalar_names(const ArrayInfo& array);
// Returns the name of the scalar on cells from which the point scalar `name` was interpolated. Returns `name` if it is
// a scalar on cells, and an empty string for all other scalars.
[[nodiscard]] std::string cell_scalar(const Dataset& dataset, const std::string& name);

} // namespace server::store
