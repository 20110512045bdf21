// The kept state behind one drawable: an iso-value or slice, or a boundary surface.
#pragma once

#include "geometry/shape_pool.hpp"

#include <optional>

namespace ciel::geometry {

[[nodiscard]] std::uint64_t unique_number(); // never 0, never twice

// An iso-surface colored by its own array has one color, `value`: what interpolation makes of it would differ by
// rounding, and so lie on both sides of a step's bound.
struct OfArray {
    std::string array;
    std::optional<double> value; // that the shape has everywhere of the array it is colored by
};

// Scalars of one shape by one array, interpolated again only when either changes. Where the array is of
// the cells or of the boundary's faces, the polygons share no vertices, and each has the value of its cell or face.
struct Painted {
    std::shared_ptr<const Shape> shape;
    std::shared_ptr<const Shape> sound; // without the cells that blew up (sound_shape.hpp); mostly `shape` itself
    std::shared_ptr<const Shape> flat;  // `sound` with separated polygons, where it is shown so
    std::string array;
    std::size_t step = 0;
    std::shared_ptr<const std::vector<float>> scalars;
    bool missing = false; // some of them are no numbers
    std::uint64_t identity = unique_number(), revision = 0;

    [[nodiscard]] std::size_t memory_bytes() const {
        return (scalars ? scalars->size() * sizeof(float) : 0) + (flat ? bytes_of(*flat) : 0) +
               (sound && sound != shape ? bytes_of(*sound) : 0);
    }
    [[nodiscard]] const std::shared_ptr<const Shape>& shown() const { return flat ? flat : sound; }
    // `of`: the array that the shape is an iso-surface of; cells without a number for it are left out, too.
    void paint(const std::shared_ptr<const Shape>& new_shape, const std::string& new_array, std::size_t new_step,
               store::LoadedDataset& loaded, const OfArray& of = {});

private:
    [[nodiscard]] std::vector<float> flat_scalars(store::LoadedDataset& loaded) const;
};

// The edges of one shape's polygons, found again only when it changes.
struct Outlined {
    std::shared_ptr<const Shape> shape;
    std::shared_ptr<const std::vector<Index>> edges;
    std::uint64_t identity = unique_number(), revision = 0;

    [[nodiscard]] std::size_t memory_bytes() const { return edges ? edges->size() * sizeof(Index) : 0; }
    void follow(const std::shared_ptr<const Shape>& new_shape);
    void forget() { *this = {}; } // nobody looks at them
};

// Contour lines of one shape, found again only when the shape, the array, its step or the values change.
struct Contoured {
    std::shared_ptr<const Shape> of, lines;
    std::shared_ptr<const std::vector<float>> scalars; // a line's value at its points; null where it has one color
    std::string array;
    std::size_t step = 0;
    std::vector<double> values;
    std::uint64_t identity = unique_number(), revision = 0;

    [[nodiscard]] std::size_t memory_bytes() const;
    void follow(const std::shared_ptr<const Shape>& shape, const std::string& new_array, std::size_t new_step,
                const std::vector<double>& new_values, bool colored, store::LoadedDataset& loaded);
    void forget() { *this = {}; } // nobody looks at them
};

// One nu of one field. `field` is declared before `query`, which reads it until it is destroyed.
struct Cut {
    store::ScalarField field;
    std::string field_name;
    std::optional<Query> query;
    double nu = 0;
    bool normals = false;
    std::shared_ptr<ShapePool> shapes = ShapePool::make();
    std::shared_ptr<const Shape> shape;
    Painted painted;
    Outlined outlined;
    Contoured contoured;

    void use_field(const std::string& name, store::ScalarField new_field, Extraction extraction);
    // False when stopped; the shape is then made anew by the next call.
    bool extract(double new_nu, bool new_normals, const std::stop_token& stop);
    void show(std::shared_ptr<const Shape> made, double at_nu); // without normals, instead of what `extract` gives
    [[nodiscard]] std::size_t memory_bytes() const;
};

struct Boundary {
    std::string key; // what it was made from
    std::shared_ptr<const Shape> shape;
    std::shared_ptr<const Shape> of;     // the whole cap that `shape` is a part of
    std::vector<std::uint8_t> cells;     // flags of those that a threshold keeps; empty: no threshold
    std::size_t thinned = 1, points = 0; // points: every so manyth of so many is in the shape
    Painted painted;
    Outlined outlined;

    [[nodiscard]] std::size_t memory_bytes() const;
};

// The faces of the patches, or of all cells or those kept; `kept` has a flag per cell or is empty.
[[nodiscard]] Surface boundary_surface(const store::Dataset& dataset, const store::Step& step,
                                       const std::vector<std::string>& groups, std::span<const std::uint8_t> kept);
[[nodiscard]] std::shared_ptr<const Shape> triangles_shape(Surface&& surface);
// The edges of a boundary as lines: all, or those where it bends by more than `angle` degrees.
[[nodiscard]] std::shared_ptr<const Shape> edges_shape(Surface&& boundary, std::optional<double> angle);
// Its vertices, or those of all kept cells.
[[nodiscard]] std::shared_ptr<const Shape> points_shape(const Surface& boundary, std::size_t thinned);
[[nodiscard]] Surface cell_vertices(const FaceMeshView& mesh, std::span<const std::uint8_t> kept);
[[nodiscard]] std::shared_ptr<const Shape> outline_shape(Vec3d minimum, Vec3d maximum, Vec3d origin);

} // namespace ciel::geometry
