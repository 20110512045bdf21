// Structures that describe a dataset: its arrays, steps, meshes and groups.
#pragma once

#include "ciel/face_mesh.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ciel::store {

// What an array has values for. boundary_face: for the boundary faces, in the order of their ids; patches are sets of
// boundary faces.
enum class Association { point, cell, boundary_face };

// Where the values of an array come from. original: from the imported file. interpolated: from values on cells.
// derived: computed by the reader of the file format. unknown: another program or an earlier version of CIEL wrote the
// dataset.
enum class Origin { unknown, original, interpolated, derived };

struct ArraySource {
    Origin origin = Origin::original;
    std::string type; // number type in the imported file, such as "float64"; empty: not known
    std::string file; // imported file in which the array was first found; empty: not known
};

struct ArrayInfo {
    std::string name; // such as "p", "U", "cell:p", "patch:p"
    Association association = Association::point;
    int components = 1;
    std::string units; // empty: not known
    std::string description;
    std::vector<std::string> component_names = {}; // "xx", "xy"... for a tensor, in the order of the file; else empty
    ArraySource source = {};
    bool doubles = false; // stored as float64, else as float32; the same on all meshes

    [[nodiscard]] std::size_t value_bytes() const { return doubles ? sizeof(double) : sizeof(float); }
    // Returns whether both arrays have the same association and number of components.
    [[nodiscard]] bool has_shape_of(const ArrayInfo& other) const {
        return association == other.association && components == other.components;
    }
};

struct MeshInfo;
[[nodiscard]] std::uint64_t items_of(const MeshInfo& mesh, Association association);
[[nodiscard]] Vec3d middle_of(const MeshInfo& mesh);        // of its bounds
[[nodiscard]] std::string to_text(Association association); // "point", "cell", "boundary_face"
[[nodiscard]] std::string to_text(Origin origin);           // "original", "interpolated", "derived"; "unknown"

struct CellExtreme {
    Index cell = 0; // stored id of the cell
    Vec3d place{};  // mean of the cell's corners, in the dataset's coordinates
};

struct CellExtremes {
    CellExtreme lowest, highest;
};

struct ArrayStep {                 // an array at one step
    std::array<double, 2> range{}; // [min, max] of the magnitude, or of all components if there is no magnitude
    std::vector<std::array<double, 2>> component_ranges; // as in `range`, only finite values count
    std::uint64_t invalid = 0;                           // number of NaN and infinite values, without missing ones
    std::uint64_t missing = 0;                           // number of missing values (no_value.hpp)
    // For an array on cells: the cells at the ends of `range`, then, if there are several components, those of each
    // component. Empty if the cells are not known, or if one of the ranges has no finite value.
    std::vector<CellExtremes> extremes;
    // The array exists at this time, but its chunk need not be written yet (store/README.md). Until the chunk is
    // written, values() throws.
    bool lazy = false;
    bool has_checksum = false; // false if the chunk was written with plain Zarr and cannot be verified
};

struct Step {
    double time = 0;
    std::size_t mesh = 0;                    // index into the dataset's meshes
    std::size_t coordinates = 0;             // index of a coordinate set of that mesh
    std::map<std::string, ArrayStep> arrays; // by name; only arrays that were written at this time
};

struct PatchFacts {                                // the solver's settings of a patch; empty where not known
    std::string type;                              // such as "wall", "empty", "symmetryPlane"
    std::map<std::string, std::string> conditions; // array -> boundary condition at the mesh's first step
};

struct Group { // a named set of faces (a patch, or a baffle inside the mesh) or of cells (a zone)
    enum class Of { faces, cells };
    Of of = Of::faces;
    std::string name;
    Ids ids; // numbers of faces, or stored ids of cells, ascending; the dataset owns the memory
    PatchFacts facts = {};
};

struct MeshInfo {
    std::uint64_t vertices = 0, edges = 0, faces = 0, half_edges = 0, boundary_faces = 0, components = 0, cells = 0;
    std::map<std::string, std::uint64_t> cells_by_type; // number of cells by type, such as "hexahedron"
    std::array<double, 6> bounds{};                     // xmin xmax ymin ymax zmin zmax in world coordinates
    bool double_positions = false;                      // positions are stored as float64, else as float32
};

struct DatasetInfo {
    int format_version = 2;
    std::string id;      // random, made with the dataset; a dataset that replaces it has another id
    std::string name;    // the directory's name without .ciel
    std::string source;  // the input that was imported
    std::string created; // ISO 8601
    std::string length_units;
    std::uint64_t input_vertices = 0, input_edges = 0, input_cells = 0; // in the imported file, before welding
    std::vector<std::string> notes; // sentences on changes by the import, such as welded points and cells left out
    std::vector<ArrayInfo> arrays;
    std::vector<MeshInfo> meshes;
};

} // namespace ciel::store
