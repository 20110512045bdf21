// Dataset: NAME.ciel, a Zarr v2 group with raw chunks, opened for reading (format: store/README.md).
#pragma once

#include "ciel/block_ranges.hpp"
#include "ciel/numbered_faces.hpp"
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

namespace ciel::store {

struct PagedValues; // cache/paged_file.hpp

// What opening a dataset does about ranges that the commit marker lacks, as for steps appended with plain Zarr.
enum class LackingRanges {
    computed, // reads the chunks of these arrays
    left_out  // leaves them empty; for writers that append to a dataset
};

// The parsed name of a scalar: a component ("U:x", "A:0", "R:xx") or the magnitude ("U:magnitude") of an array, or an
// array of one component ("p").
struct ScalarName {
    std::string array;
    std::optional<int> component; // nullopt for a magnitude and for an array of one component
    bool magnitude = false;

    [[nodiscard]] bool operator==(const ScalarName&) const = default;
};

// Immutable view of the steps that were committed when the dataset was opened or refreshed. Spans and views of meshes
// from it are valid as long as the shared pointer lives. Files are mapped, and writers must replace them instead of
// truncating or rewriting them. If a file is truncated or rewritten all the same, no read fails: views check each
// index, and check_intact throws. Thread-safe.
class Dataset : public std::enable_shared_from_this<Dataset> {
public:
    // Throws Error that names the file when one is missing, damaged, truncated or of a newer version, or when
    // `directory` is not a dataset. Arrays, records and the arrays of a step in the table of steps are read and
    // verified at their first use, not here.
    // `access`: how records, values and positions are read; nullopt: as the file system demands. The numbered faces are
    // always mapped.
    [[nodiscard]] static std::shared_ptr<Dataset> open(const std::filesystem::path& directory,
                                                       LackingRanges lacking = LackingRanges::computed,
                                                       std::optional<FileAccess> access = std::nullopt);
    virtual ~Dataset() = default;

    [[nodiscard]] virtual const std::filesystem::path& directory() const = 0; // as given to open()
    [[nodiscard]] virtual const DatasetInfo& info() const = 0;
    [[nodiscard]] virtual const Steps& steps() const = 0;
    // Returns the dataset with the steps committed since it was opened or refreshed, or nullptr when there are none.
    // Both datasets share the mapped files. Checks the mapped files and those of the new steps. Throws Error when one
    // is damaged or the dataset was replaced by another.
    [[nodiscard]] virtual std::shared_ptr<Dataset> refreshed() const = 0;

    // Throws Error that names a mapped file if one was found to be truncated or rewritten since it was opened. Call it
    // after reading: if it throws, results made from the dataset must be discarded. Costs one atomic read if no file is
    // lost.
    virtual void check_intact() const = 0;
    [[nodiscard]] bool is_intact() const; // false if check_intact would throw
    // Reads all that is on the disk. Throws Error that names the first file that is damaged.
    virtual void verify() const = 0;
    // Like check_intact, but first looks for topology files that were truncated or rewritten and not yet found. Makes a
    // stat call per file.
    virtual void check_unchanged() const = 0;

    [[nodiscard]] virtual std::size_t memory_bytes() const = 0; // of copied values and positions (FileAccess::read)

    // Returns the mesh with all its faces (all_faces in ciel/numbered_faces.hpp), which no picture needs. They take
    // memory while somebody uses them; in format 1 they are mapped. Throws Error that names a file that is damaged.
    [[nodiscard]] virtual FaceMeshView mesh(std::size_t mesh, std::size_t coordinates) const = 0;
    // Returns the mesh without its faces: face_count() is 0. Reads positions only.
    [[nodiscard]] virtual FaceMeshView points(std::size_t mesh, std::size_t coordinates) const = 0;
    // Likewise, but reads nothing: positions are read and checked when the view's loader loads them. If the mesh was
    // stored without blocks, all are read here.
    [[nodiscard]] virtual FaceMeshView points_to_load(std::size_t mesh, std::size_t coordinates) const = 0;
    // Returns the numbered faces (ciel/numbered_faces.hpp), which are checked at the first call, with positions to
    // load. The ids of a group of faces are their numbers. Throws Error like mesh().
    [[nodiscard]] virtual FaceMeshView numbered_faces(std::size_t mesh, std::size_t coordinates) const = 0;
    // Returns the first of the numbered faces: those on the boundary.
    [[nodiscard]] virtual FaceMeshView boundary(std::size_t mesh, std::size_t coordinates) const = 0;
    // Returns the topology of a mesh. It reads the records of its blocks when they are used, and keeps their files
    // open. If the mesh was stored without blocks, the topology is built here.
    [[nodiscard]] virtual Topology topology(std::size_t mesh) const = 0;
    [[nodiscard]] virtual std::vector<Group> groups(std::size_t mesh) const = 0;
    [[nodiscard]] virtual std::span<const Index> original_vertex(std::size_t mesh) const = 0;
    [[nodiscard]] virtual std::span<const Index> original_cell(std::size_t mesh) const = 0;
    // Ids that the solver gave to vertices and cells, -1 where it gave none; empty if the source has no such ids. They
    // may be any numbers and are not indices.
    [[nodiscard]] virtual std::span<const std::int64_t> solver_vertex(std::size_t mesh) const = 0;
    [[nodiscard]] virtual std::span<const std::int64_t> solver_cell(std::size_t mesh) const = 0;
    // Return the same ids for one vertex or cell; nullopt where the solver gave none. Read one page each. The vertex
    // and the cell must exist.
    [[nodiscard]] virtual Index original_vertex(std::size_t mesh, Index vertex) const = 0;
    [[nodiscard]] virtual Index original_cell(std::size_t mesh, Index cell) const = 0;
    [[nodiscard]] virtual std::optional<std::int64_t> solver_vertex(std::size_t mesh, Index vertex) const = 0;
    [[nodiscard]] virtual std::optional<std::int64_t> solver_cell(std::size_t mesh, Index cell) const = 0;
    // Returns the array's values at a step: `components` numbers per vertex, cell or boundary face, interleaved,
    // doubles if ArrayInfo::doubles. Empty when the array was not written at this step. Throws Error for an unknown
    // array or a damaged chunk.
    [[nodiscard]] virtual Values values(const std::string& array, std::size_t step) const = 0;
    // Likewise, but reads nothing: pages are read and checked when they are loaded.
    [[nodiscard]] virtual PagedValues values_to_load(const std::string& array, std::size_t step) const = 0;

    // Returns the ranges of a scalar on points, by block of the mesh; nullopt when none are stored, as for a step that
    // was appended with plain Zarr, and for scalars that are not on points. Throws Error when they are damaged.
    [[nodiscard]] virtual std::optional<BlockRanges> block_ranges(const ScalarName& scalar, std::size_t step) const = 0;

    // Returns the histogram of any scalar, with stored_bins, over the range of its finite values; nullopt when none is
    // stored. Throws Error when it is damaged.
    [[nodiscard]] virtual std::optional<Histogram> histogram(const ScalarName& scalar, std::size_t step) const = 0;

    // Returns the boxes around the vertices of each block; nullopt when none are stored.
    [[nodiscard]] virtual std::optional<BlockBoxes> block_boxes(std::size_t mesh, std::size_t coordinates) const = 0;

    [[nodiscard]] const ArrayInfo* find(const std::string& array) const;
    [[nodiscard]] std::size_t step_at(double time) const; // index of the step whose time is nearest
};

// Returns whether the array has a magnitude: the length of a vector of two or three components, or the Frobenius norm
// of a tensor (an array with component names).
[[nodiscard]] bool has_magnitude(const ArrayInfo& array);
[[nodiscard]] double magnitude_of(const ArrayInfo& array, ValuesView tuple);
// Set `out` to the scalar of each tuple. `tuples`: the components, interleaved. A magnitude is no_value (no_value.hpp)
// if one component is.
void scalars_in(const ArrayInfo& array, std::span<const float> tuples, const ScalarName& scalar, std::span<float> out);
void scalars_in(const ArrayInfo& array, std::span<const double> tuples, const ScalarName& scalar,
                std::span<double> out);
// Returns the scalar of each tuple, in the type of `values`. `values`: the components, interleaved.
[[nodiscard]] Values one_scalar(const ArrayInfo& array, ValuesView values, const ScalarName& scalar);
// Returns the scalars of an array, in the order of scalar_names.
[[nodiscard]] std::vector<ScalarName> scalars_of(const ArrayInfo& array);
// Throws Error that lists the existing names when there is no scalar `name`.
[[nodiscard]] ScalarName parse_scalar(const Dataset& dataset, const std::string& name);
[[nodiscard]] std::vector<std::string> scalar_names(const ArrayInfo& array);
// Returns the scalar on cells that the point scalar `name` was interpolated from. Returns `name` if it is a scalar on
// cells, and an empty string for all other scalars.
[[nodiscard]] std::string cell_scalar(const Dataset& dataset, const std::string& name);

} // namespace ciel::store
