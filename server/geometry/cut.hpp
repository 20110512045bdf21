// The state that is kept between updates for one drawable: an iso-surface, a slice or a boundary surface.
#pragma once

#include "ciel/threshold_surface.hpp"
#include "geometry/shape_pool.hpp"

#include <optional>

namespace server::geometry {

[[nodiscard]] std::uint64_t unique_number(); // never 0, and never the same twice

// The array of an iso-surface. If the surface is colored by this array, all its vertices get the iso-value.
// Interpolated values would differ by rounding, and might lie on both sides of the bound between two color steps.
struct OfArray {
    std::string array;
    std::optional<double> value; // the iso-value, if the surface is colored by `array`
};

// A shape that is colored by one array: the scalars of its vertices. If the array is on cells or boundary faces, the
// polygons share no vertices, and each polygon has the value of its cell or face.
struct Painted {
    std::shared_ptr<const Shape> shape;
    std::shared_ptr<const Shape> sound; // without cells that are not sound (sound_shape.hpp); often `shape` itself
    std::shared_ptr<const Shape> flat;  // `sound` with separated polygons; null for point arrays
    std::string array;
    std::size_t step = 0;
    std::optional<store::Values> scalars; // in the array's type
    double scalar_origin = 0;             // Drawable::scalar_origin
    bool missing = false;                 // true if some scalars are NaN or infinite
    std::uint64_t identity = unique_number(), revision = 0;

    [[nodiscard]] std::size_t memory_bytes() const {
        return (scalars ? scalars->size_bytes() : 0) + (flat ? bytes_of(*flat) : 0) +
               (sound && sound != shape ? bytes_of(*sound) : 0);
    }
    [[nodiscard]] const std::shared_ptr<const Shape>& shown() const { return flat ? flat : sound; }
    // Sets the shape, the array and the step. `of`: the array of the iso-surface; cells that have no number for this
    // array are left out, too. Throws store::NotWritten if an array was not written at the step.
    void paint(const std::shared_ptr<const Shape>& new_shape, const std::string& new_array, std::size_t new_step,
               store::LoadedDataset& loaded, const OfArray& of = {});

private:
    [[nodiscard]] store::Values flat_scalars(store::LoadedDataset& loaded) const;
};

// The edges of one shape's polygons. They are searched again only when the shape changes.
struct Outlined {
    std::shared_ptr<const Shape> shape;
    std::shared_ptr<const std::vector<ciel::Index>> edges;
    std::uint64_t identity = unique_number(), revision = 0;

    [[nodiscard]] std::size_t memory_bytes() const { return edges ? edges->size() * sizeof(ciel::Index) : 0; }
    void follow(const std::shared_ptr<const Shape>& new_shape);
    void forget() { *this = {}; } // call when the edges are not shown
};

// The contour lines of one shape. They are computed again only when the shape, its scalars or the values change.
struct Contoured {
    std::shared_ptr<const Shape> of, lines;
    std::optional<store::Values> scalars; // by point: value of its line; nullopt for a solid color
    double scalar_origin = 0;             // Drawable::scalar_origin
    std::string array;
    std::size_t step = 0;
    std::vector<double> values;
    std::uint64_t identity = unique_number(), revision = 0;

    [[nodiscard]] std::size_t memory_bytes() const;
    void follow(const std::shared_ptr<const Shape>& shape, const std::string& new_array, std::size_t new_step,
                const std::vector<double>& new_values, bool colored, store::LoadedDataset& loaded);
    void forget() { *this = {}; } // call when the lines are not shown
};

// The surface of one field at one iso-value `nu`. A slice is a surface of a field of distances. `query` has a copy of
// the field.
struct Cut {
    store::ScalarField field;
    std::string field_name;
    std::optional<ciel::Query> query;
    double nu = 0;
    bool normals = false;
    std::shared_ptr<ShapePool> shapes = ShapePool::make();
    std::shared_ptr<const Shape> shape;
    Painted painted;
    Outlined outlined;
    Contoured contoured;

    void use_field(const std::string& name, store::ScalarField new_field, ciel::Extraction extraction);
    // Returns false if `stop` was requested; the next call then extracts again.
    bool extract(double new_nu, bool new_normals, const std::stop_token& stop);
    void show(std::shared_ptr<const Shape> made, double at_nu); // replaces the extracted shape; `made` has no normals
    [[nodiscard]] std::size_t memory_bytes() const;
};

struct Boundary {
    std::string key; // identifies the inputs of `shape`
    std::shared_ptr<const Shape> shape;
    std::shared_ptr<const Shape> of;     // for a cap: the shape of the Cut that the cap is a part of
    std::vector<std::uint8_t> cells;     // one flag per cell: the threshold keeps it; empty without a threshold
    std::size_t thinned = 1, points = 0; // for a points layer: every `thinned`-th of `points` points is shown
    Painted painted;
    Outlined outlined;

    [[nodiscard]] std::size_t memory_bytes() const;
};

// Returns the faces of the patches `groups` that belong to kept cells. Without groups, returns the boundary of the kept
// cells. Positions are relative to `origin`. `kept`: one flag per cell; if it is empty, all cells are kept.
// polygon_face of the result: the number of the face, or `none` for a face inside the mesh that has no number.
[[nodiscard]] ciel::Surface boundary_surface(store::LoadedDataset& loaded, std::size_t step, const ciel::Vec3d& origin,
                                             const std::vector<std::string>& groups,
                                             std::span<const std::uint8_t> kept);
[[nodiscard]] std::shared_ptr<const Shape> triangles_shape(ciel::Surface&& surface);
// `angle`: if set, only the edges at which the boundary bends by more than this many degrees.
[[nodiscard]] std::shared_ptr<const Shape> edges_shape(ciel::Surface&& boundary, std::optional<double> angle);
// Returns every `thinned`-th vertex of the boundary as a point.
[[nodiscard]] std::shared_ptr<const Shape> points_shape(const ciel::Surface& boundary, std::size_t thinned);
[[nodiscard]] std::shared_ptr<const Shape> outline_shape(ciel::Vec3d minimum, ciel::Vec3d maximum, ciel::Vec3d origin);

} // namespace server::geometry
