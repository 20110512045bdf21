// A dataset on disk, opened for reading: NAME.ciel, a Zarr v2 group with raw chunks (store/README.md is the format).
#pragma once

#include "ciel/face_mesh.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ciel::store {

// Of the faces only those of the boundary, in the order of their ids; they are what patches are made of.
enum class Association { point, cell, boundary_face };

// How the values came to be: as the file has them, from values of the cells, or by the formulas of a reader. A dataset
// that was written by others, or before origins were kept, does not say.
enum class Origin { unknown, original, interpolated, derived };

struct ArraySource {
    Origin origin = Origin::original;
    std::string type; // of the numbers in the file, "float64"; empty: not known
    std::string file; // where they were first read from; empty: not known
};

struct ArrayInfo {
    std::string name; // "p", "U", "cell:p", "patch:p"
    Association association = Association::point;
    int components = 1;
    std::string units; // empty: not known
    std::string description;
    std::vector<std::string> component_names = {}; // of a tensor, in the order of the file: "xx", "xy"; else empty
    ArraySource source = {};
};

struct MeshInfo;
[[nodiscard]] std::uint64_t items_of(const MeshInfo& mesh, Association association);
[[nodiscard]] std::string to_text(Association association); // "point", "cell", "boundary_face"
[[nodiscard]] std::string to_text(Origin origin);           // "original", "interpolated", "derived"; "unknown"

struct CellExtreme {
    Index cell = 0; // stored id
    Vec3d place{};  // the mean of its corners, in the dataset's coordinates
};

struct CellExtremes {
    CellExtreme lowest, highest;
};

struct ArrayStep {                 // one array at one step
    std::array<double, 2> range{}; // of the magnitude, where there is none of all components; finite values only
    std::vector<std::array<double, 2>> component_ranges;
    std::uint64_t invalid = 0; // NaN or infinite values that the solver came to...
    std::uint64_t missing = 0; // ...and those that are not there (no_value.hpp)
    // Of an array of the cells: which of them have the ends of `range`, and, of several components, those of each of
    // component_ranges. Empty where no value is finite, or where it is not known.
    std::vector<CellExtremes> extremes;
    // Known to exist at this time, but its chunk may not be written yet (store/README.md): values() throws until it is.
    bool lazy = false;
    bool has_checksum = false; // else its chunk cannot be verified: written with plain Zarr
};

struct Step {
    double time = 0;
    std::size_t mesh = 0;                    // index into the dataset's meshes
    std::size_t coordinates = 0;             // index into that mesh's position sets
    std::map<std::string, ArrayStep> arrays; // an array that is not here was not written at this time
};

struct PatchFacts {                                // what the solver says of a patch; empty where it is not known
    std::string type;                              // "wall", "empty", "symmetryPlane"
    std::map<std::string, std::string> conditions; // array -> boundary condition at the mesh's first step
};

struct Group { // a named set of boundary faces (a patch) or of cells (a zone)
    enum class Of { faces, cells };
    Of of = Of::faces;
    std::string name;
    Ids ids; // sorted stored ids, borrowed from the dataset
    PatchFacts facts = {};
};

struct MeshInfo {
    std::uint64_t vertices = 0, edges = 0, faces = 0, half_edges = 0, boundary_faces = 0, components = 0, cells = 0;
    std::map<std::string, std::uint64_t> cells_by_type; // "hexahedron": n
    std::array<double, 6> bounds{};                     // xmin xmax ymin ymax zmin zmax, origin added
};

struct DatasetInfo {
    int format_version = 1;
    std::string id;      // random, made once: tells a replaced dataset from a grown one
    std::string name;    // the directory's name without .ciel
    std::string source;  // what was imported
    std::string created; // ISO 8601
    std::string length_units;
    std::uint64_t input_vertices = 0, input_edges = 0, input_cells = 0; // as the file has them, before welding
    std::vector<std::string> notes; // sentences: welded points, cells left out (ids), quadratic cells reduced...
    std::vector<ArrayInfo> arrays;
    std::vector<MeshInfo> meshes;
};

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
