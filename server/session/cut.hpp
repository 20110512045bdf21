// The kept state behind one drawable: an iso-value or slice, or a boundary surface.
#pragma once

#include "session/scene_geometry.hpp"

#include <optional>

namespace ciel::session {

[[nodiscard]] std::uint64_t unique_number(); // never 0, never twice

// Scalars of one shape by one array, interpolated again only when either changes.
struct Painted {
    std::shared_ptr<const Shape> shape;
    std::string array;
    std::size_t step = 0;
    std::shared_ptr<const std::vector<float>> scalars;
    std::uint64_t identity = unique_number(), revision = 0;

    [[nodiscard]] std::size_t memory_bytes() const { return scalars ? scalars->size() * sizeof(float) : 0; }
    // own: what the array is everywhere on the shape. An iso-surface coloured by its own array has one colour: what
    // interpolation makes of the value would differ by rounding, and so lie on both sides of a step's bound.
    void paint(const std::shared_ptr<const Shape>& new_shape, const std::string& new_array, std::size_t new_step,
               store::LoadedDataset& loaded, std::optional<double> own = {});
};

// One nu of one field. `field` is declared before `query`, which reads it until it is destroyed.
struct Cut {
    store::ScalarField field;
    std::string field_name;
    std::optional<Query> query;
    double nu = 0;
    bool normals = false;
    std::shared_ptr<const Shape> shape;
    Painted painted;

    void use_field(const std::string& name, store::ScalarField new_field, Extraction extraction);
    // False when stopped; the shape is then made anew by the next call.
    bool extract(double new_nu, bool new_normals, const std::stop_token& stop);
    [[nodiscard]] std::size_t memory_bytes() const;
};

struct Boundary {
    std::string key; // what it was made from
    std::shared_ptr<const Shape> shape;
    Painted painted;

    [[nodiscard]] std::size_t memory_bytes() const;
};

[[nodiscard]] std::shared_ptr<const Shape> boundary_shape(const store::Dataset& dataset, const store::Step& step,
                                                          const std::vector<std::string>& groups);
[[nodiscard]] std::shared_ptr<const Shape> outline_shape(Vec3d minimum, Vec3d maximum, Vec3d origin);

} // namespace ciel::session
