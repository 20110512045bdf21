// Describes a dataset: its arrays, steps, meshes and groups. Plain structures that refer to no open file.
#pragma once

#include "ciel/face_mesh.hpp"

#include <array>
#include <cstdint>
#include <map>
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

} // namespace ciel::store
