// The gradient of a scalar field in one cell (paper, section 3): least squares over the cell's vertices. Departure from
// the paper: the normal equations are centered, 3 x 3 and in double, because the paper's 4 x 4 system in float loses
// all precision far from the origin. stretched_cells.cpp solves strongly stretched cells (boundary layers). Functions
// are inline, because passing the samples of a tetrahedron to a call takes longer than the arithmetic.
#pragma once

#include "ciel/vectors.hpp"
#include "mesh/standard_shapes.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <span>

namespace ciel {

struct CellGradient {
    Vec3f gradient{}; // units of the value per unit of length
    // In units of length cubed. 0 when the cell has no volume or a vertex has no value; the cell then has no weight.
    // The type is double, because the cube of a float length may not fit a float.
    double volume = 0;
};

struct Sample {
    double x, y, z, value; // position and value; a value of NaN means no value
};

// Four doubles in one vector type. An operation takes at most two instructions on any x86-64 or arm64.
using Four = double __attribute__((vector_size(32)));

[[nodiscard]] inline Four load(const Sample& sample) {
    Four four;
    std::memcpy(&four, &sample, sizeof four);
    return four;
}

[[nodiscard]] inline Vec3d arm(const Sample& from, const Sample& to) {
    return {to.x - from.x, to.y - from.y, to.z - from.z};
}

struct LeastSquares {
    Vec3f gradient{};
    Sample mean{0, 0, 0, 0};
    bool good = false; // true if the samples span a volume and all have a value
};

// Sums over samples. d: a sample minus the mean of the samples.
struct Moments {
    Four mean{};
    Four squares{};  // of d * d
    Four products{}; // of d.x * d.y, d.y * d.z, d.x * d.z
    Four slopes{};   // of d * d.value
};

// Subtracts the mean from each of `samples` (a std::array or std::vector) and returns their moments.
template <class Samples>
[[nodiscard]] inline Moments centered(Samples& samples) {
    Moments out;
    Four sum{};
    for (const Sample& s : samples) sum += load(s);
    out.mean = sum * (1.0 / static_cast<double>(samples.size()));
    for (Sample& s : samples) {
        const Four d = load(s) - out.mean;
        std::memcpy(&s, &d, sizeof d);
        out.squares += d * d;
        out.products += d * __builtin_shufflevector(d, d, 1, 2, 0, 3);
        out.slopes += d * __builtin_shufflevector(d, d, 3, 3, 3, 3);
    }
    return out;
}

// The inverse of the matrix. It depends on positions only. Number: double, or Four for four cells at once.
template <class Number>
struct NormalEquationsOf {
    Number xx{}, xy{}, xz{}, yy{}, yz{}, zz{}; // cofactors of the matrix
    Number inverse_determinant{};              // 0 if the samples are too stretched for normal equations

    NormalEquationsOf() = default;
    // a, b, c, ab, bc, ac: sums of x * x, y * y, z * z, x * y, y * z, x * z over samples relative to their mean.
    NormalEquationsOf(Number a, Number b, Number c, Number ab, Number bc, Number ac)
        : xx(b * c - bc * bc), xy(ac * bc - ab * c), xz(ab * bc - ac * b), yy(a * c - ac * ac), yz(ab * ac - a * bc),
          zz(a * b - ab * ab) {
        const Number determinant = a * xx + ab * xy + ac * xz;
        const Number size = (a + b + c) / 3.0;
        inverse_determinant = determinant > 1e-9 * size * size * size ? 1.0 / determinant : Number{};
    }
    // x, y, z: sums of x * value, y * value, z * value over the same samples.
    [[nodiscard]] std::array<Number, 3> gradient(Number x, Number y, Number z) const {
        return {(xx * x + xy * y + xz * z) * inverse_determinant, (xy * x + yy * y + yz * z) * inverse_determinant,
                (xz * x + yz * y + zz * z) * inverse_determinant};
    }
};

struct NormalEquations : NormalEquationsOf<double> {
    NormalEquations() = default;
    explicit NormalEquations(const Moments& of)
        : NormalEquationsOf(of.squares[0], of.squares[1], of.squares[2], of.products[0], of.products[1],
                            of.products[2]) {}
    [[nodiscard]] Vec3f gradient(const Four& slopes) const {
        const auto [x, y, z] = NormalEquationsOf::gradient(slopes[0], slopes[1], slopes[2]);
        return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    }
};

// `samples` must be relative to their mean. They are sheared, which does not change volumes. Returns false when they
// lie in a plane, up to rounding. The error is about 1e-16 times the aspect ratio of the cell, which may be up to 1e10.
[[nodiscard]] bool fit_stretched(std::span<Sample> samples, const Sample& mean, Vec3f& gradient);
[[nodiscard]] CellGradient stretched_tetrahedron_gradient(std::array<Sample, 4> samples);

// On return, the samples are relative to their mean, and possibly sheared by fit_stretched.
template <class Samples>
[[nodiscard]] inline LeastSquares least_squares(Samples& samples) {
    LeastSquares out;
    const Moments moments = centered(samples);
    std::memcpy(&out.mean, &moments.mean, sizeof out.mean);
    if (!std::isfinite(out.mean.value)) return out;
    const NormalEquations equations(moments);
    out.good = equations.inverse_determinant > 0;
    if (out.good)
        out.gradient = equations.gradient(moments.slopes);
    else
        out.good = fit_stretched(samples, out.mean, out.gradient);
    return out;
}

// `samples` are relative to their mean. Returns the volume of the cell: the sum of the volumes of the pyramids from the
// mean to each face. The area vector of a quadrangle is half the cross product of its diagonals.
template <const StandardShape& shape>
[[nodiscard]] inline double standard_volume(const std::array<Sample, shape.corners>& samples) {
    double six_volumes = 0;
    for (std::size_t face = 0; face < shape.faces; ++face) {
        const std::size_t h = shape.face_begin[face];
        const Sample &a = samples[shape.origin[h]], &b = samples[shape.origin[h + 1]],
                     &c = samples[shape.origin[h + 2]];
        const Vec3d area = shape.face_size(face) == 3 ? cross(arm(a, b), arm(a, c))
                                                      : cross(arm(a, c), arm(b, samples[shape.origin[h + 3]]));
        six_volumes += dot(Vec3d{a.x, a.y, a.z}, area);
    }
    return std::abs(six_volumes) / 6;
}

[[nodiscard]] inline CellGradient tetrahedron_gradient(const std::array<Sample, 4>& samples) {
    const Vec3d a = arm(samples[0], samples[1]), b = arm(samples[0], samples[2]), c = arm(samples[0], samples[3]);
    const Vec3d bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const double six_volumes = dot(a, bc);
    double size = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) size += a[axis] * a[axis] + b[axis] * b[axis] + c[axis] * c[axis];
    const double u = samples[1].value - samples[0].value, v = samples[2].value - samples[0].value,
                 w = samples[3].value - samples[0].value;
    if (!std::isfinite(u + v + w)) return {};
    if (!(six_volumes * six_volumes > 1e-12 * size * size * size)) return stretched_tetrahedron_gradient(samples);
    const double share = 1 / six_volumes;
    return {{static_cast<float>((u * bc[0] + v * ca[0] + w * ab[0]) * share),
             static_cast<float>((u * bc[1] + v * ca[1] + w * ab[1]) * share),
             static_cast<float>((u * bc[2] + v * ca[2] + w * ab[2]) * share)},
            std::abs(six_volumes) / 6};
}

// `samples`: one sample per corner, in the order of the shape. They are overwritten.
template <const StandardShape& shape>
[[nodiscard]] inline CellGradient standard_gradient(std::array<Sample, shape.corners>& samples) {
    if constexpr (shape.type == CellType::tetrahedron) {
        return tetrahedron_gradient(samples);
    } else {
        const LeastSquares fit = least_squares(samples);
        if (!fit.good) return {};
        return {fit.gradient, standard_volume<shape>(samples)};
    }
}

} // namespace ciel
