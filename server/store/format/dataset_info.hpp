// Structures that describe a dataset: its arrays, steps, meshes and groups.
#pragma once

#include "ciel/face_mesh.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace server::store {

// The items of the mesh that have the values of an array. Values on boundary faces are in the order of the faces' ids.
enum class Association { point, cell, boundary_face };

// Source of an array's values. original: the imported file. interpolated: values on cells. derived: computed by the
// reader of the file format. unknown: another program or an earlier version of CIEL wrote the dataset.
enum class Origin { unknown, original, interpolated, derived };

struct ArraySource {
    Origin origin = Origin::original;
    std::string type; // number type in the imported file, such as "float64"; empty if not known
    std::string file; // imported file in which the array was first found; empty if not known
};

struct ArrayInfo {
    std::string name; // such as "p", "U", "cell:p", "patch:p"
    Association association = Association::point;
    int components = 1;
    std::string units; // empty if not known
    std::string description;
    // Only for tensors: "xx", "xy" and so on, in the order of the imported file. Empty for other arrays.
    std::vector<std::string> component_names = {};
    ArraySource source = {};
    bool doubles = false; // true: stored as float64; false: as float32; the same on all meshes

    [[nodiscard]] std::size_t value_bytes() const { return doubles ? sizeof(double) : sizeof(float); }
    [[nodiscard]] bool has_shape_of(const ArrayInfo& other) const {
        return association == other.association && components == other.components;
    }
};

struct MeshInfo;
[[nodiscard]] std::uint64_t items_of(const MeshInfo& mesh, Association association);
[[nodiscard]] ciel::Vec3d middle_of(const MeshInfo& mesh);  // center of the bounds
[[nodiscard]] std::string to_text(Association association); // "point", "cell", "boundary_face"
[[nodiscard]] std::string to_text(Origin origin);           // "original", "interpolated", "derived" or "unknown"

struct CellExtreme {
    ciel::Index cell = 0; // id of the cell in the dataset
    ciel::Vec3d place{};  // mean position of the cell's corners, in dataset coordinates
};

struct CellExtremes {
    CellExtreme lowest, highest;
};

struct ArrayStep { // what is known about an array at one step
    // [min, max] of the finite magnitudes, or of all finite components if there is no magnitude
    std::array<double, 2> range{};
    std::vector<std::array<double, 2>> component_ranges; // [min, max] of the finite values, by component
    std::uint64_t invalid = 0; // number of NaN and infinite values that are not missing values
    std::uint64_t missing = 0; // number of missing values (no_value.hpp)
    // Only for an array on cells: the cells with the ends of `range`. If there are several components, then the cells
    // with the ends of each component's range. Empty if the cells are not known, or if one of the ranges has no finite
    // value.
    std::vector<CellExtremes> extremes;
    bool late = false;         // true: the values have not been read from the source yet (store/README.md)
    bool has_checksum = false; // false if the chunk was written with plain Zarr and cannot be verified
};

struct Step {
    double time = 0;
    std::size_t mesh = 0;                    // index into the dataset's meshes
    std::size_t coordinates = 0;             // index of a coordinate set of that mesh
    std::map<std::string, ArrayStep> arrays; // by array name; only arrays that were written at this time
};

struct PatchFacts {                                // the solver's settings of a patch; empty if not known
    std::string type;                              // such as "wall", "empty", "symmetryPlane"
    std::map<std::string, std::string> conditions; // array name -> boundary condition, at the mesh's first step
};

struct Group { // a named set of faces (a patch, or a baffle inside the mesh) or of cells (a zone)
    enum class Of { faces, cells };
    Of of = Of::faces;
    std::string name;
    ciel::Ids ids; // numbers of numbered faces (mesh_arrays.hpp) or cell ids, ascending; the dataset owns the memory
    PatchFacts facts = {};
};

struct MeshInfo {
    std::uint64_t vertices = 0, edges = 0, faces = 0, half_edges = 0, boundary_faces = 0, components = 0, cells = 0;
    std::map<std::string, std::uint64_t> cells_by_type; // number of cells by type, such as "hexahedron"
    std::array<double, 6> bounds{};                     // xmin xmax ymin ymax zmin zmax in world coordinates
    bool double_positions = false;                      // true: positions are stored as float64; false: as float32
};

// The input of an import that wrote only some of the steps. Late arrays (late_files.hpp) are read from this input. If
// `inputs` is empty, no array is late.
struct LateSource {
    std::vector<std::string> inputs;                         // absolute paths
    std::map<std::string, std::vector<std::string>> options; // of the import, by the name of the option
    std::int64_t changed = 0; // time of the inputs' last change when they were imported, in ns since 1970 (UTC)
    // By step: checksum of the names, sizes and times of the step's files; empty if its arrays are not late. If all
    // entries are empty, the files of a step are not known, and the source must not have changed since `changed`.
    std::vector<std::string> files{};
    // Text by which an import recognizes the mesh of a step; empty: the import must match the mesh with the stored
    // mesh.
    std::string mesh{};
};

struct DatasetInfo {
    int format_version = 2;
    std::string id;      // random; a dataset that replaces this dataset gets another id
    std::string name;    // the directory's name without .ciel
    std::string source;  // the input that was imported
    std::string created; // ISO 8601
    std::string length_units;
    std::uint64_t input_vertices = 0, input_edges = 0, input_cells = 0; // in the imported file, before welding
    std::vector<std::string> notes; // sentences about changes that the import made, such as welded points
    LateSource late;
    std::vector<ArrayInfo> arrays;
    std::vector<MeshInfo> meshes;
};

} // namespace server::store
