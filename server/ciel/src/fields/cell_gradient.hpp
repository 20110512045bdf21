// The gradient of a scalar field in one cell (paper, section 3): least squares over the cell's vertices. Departure from
// the paper: the normal equations are centered, 3 x 3 and in double, because the paper's 4 x 4 system in float loses
// all precision far from the origin. stretched_cells.cpp solves strongly stretched cells (boundary layers). Functions
// are inline, because passing the samples of a tetrahedron to a call takes longer than the arithmetic.
#pragma once

#include "ciel/vectors.hpp"
#include "fields/four.hpp"
#include "mesh/standard_shapes.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <span>

namespace ciel::detail {

struct CellGradient {
    Vec3f gradient{}; // units of the value per unit of length
    // In units of length cubed. 0 when the cell has no volume or a vertex has no value; the cell then has no weight.
    // The type is double, because the cube of a float length may not fit a float.
    double volume = 0;
};

// Number, here and below: double, or Four for four cells at once. Shared templates give both the same bits.
template <class Number>
struct SampleOf {
    Number x, y, z, value; // position and value; a value of NaN means no value
};
using Sample = SampleOf<double>;

[[nodiscard]] inline Four load(const Sample& sample) {
    Four four;
    std::memcpy(&four, &sample, sizeof four);
    return four;
}

using ciel::arm; // else the overload for samples would hide it
template <class Number>
[[nodiscard]] inline std::array<Number, 3> arm(const SampleOf<Number>& from, const SampleOf<Number>& to) {
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
        out.products += d * first_three_rotated(d);
        out.slopes += d * last_repeated(d);
    }
    return out;
}

// The inverse of the matrix of the normal equations, which depends on positions only.
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
        inverse_determinant = inverse_if_above(determinant, 1e-9 * size * size * size);
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

// Sets `gradient` to the gradient in a stretched cell. `samples`: relative to their mean. The function shears the
// samples, which does not change volumes. Returns false when the samples lie in a plane, up to rounding. The error is
// about 1e-16 times the aspect ratio of the cell, which may be up to 1e10.
[[nodiscard]] bool fit_stretched(std::span<Sample> samples, const Sample& mean, Vec3f& gradient);
[[nodiscard]] CellGradient stretched_tetrahedron_gradient(std::array<Sample, 4> samples);

// Returns the least-squares gradient and the mean of the samples. On return, the samples are relative to their mean,
// and possibly sheared by fit_stretched.
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
template <const StandardShape& shape, class Number>
[[nodiscard]] inline Number standard_volume(const std::array<SampleOf<Number>, shape.corners>& samples) {
    Number six_volumes{};
    for (std::size_t face = 0; face < shape.faces; ++face) {
        const std::size_t h = shape.face_begin[face];
        const auto &a = samples[shape.origin[h]], &b = samples[shape.origin[h + 1]], &c = samples[shape.origin[h + 2]];
        const std::array<Number, 3> area = shape.face_size(face) == 3
                                               ? cross(arm(a, b), arm(a, c))
                                               : cross(arm(a, c), arm(b, samples[shape.origin[h + 3]]));
        six_volumes += dot(std::array<Number, 3>{a.x, a.y, a.z}, area);
    }
    return absolute(six_volumes) / 6.0;
}

// Always inlined, for the reason at the top of this file.
template <class Number>
struct TetrahedronOf {
    std::array<Number, 3> bc, ca, ab; // cross products of the arms a, b, c from the first corner
    Number six_volumes, size;         // signed; sum of the squares of the arms
    Number u, v, w;                   // values at the ends of the arms, relative to the first corner

    [[gnu::always_inline]] explicit TetrahedronOf(const std::array<SampleOf<Number>, 4>& samples) {
        const std::array<Number, 3> a = arm(samples[0], samples[1]), b = arm(samples[0], samples[2]),
                                    c = arm(samples[0], samples[3]);
        bc = cross(b, c);
        ca = cross(c, a);
        ab = cross(a, b);
        six_volumes = dot(a, bc);
        size = a[0] * a[0] + b[0] * b[0] + c[0] * c[0];
        size += a[1] * a[1] + b[1] * b[1] + c[1] * c[1];
        size += a[2] * a[2] + b[2] * b[2] + c[2] * c[2];
        u = samples[1].value - samples[0].value;
        v = samples[2].value - samples[0].value;
        w = samples[3].value - samples[0].value;
    }
    [[nodiscard, gnu::always_inline]] auto is_solid() const {
        return six_volumes * six_volumes > 1e-12 * size * size * size;
    }
    [[nodiscard, gnu::always_inline]] std::array<Number, 3> gradient() const {
        const Number share = 1.0 / six_volumes;
        return {(u * bc[0] + v * ca[0] + w * ab[0]) * share, (u * bc[1] + v * ca[1] + w * ab[1]) * share,
                (u * bc[2] + v * ca[2] + w * ab[2]) * share};
    }
};

[[nodiscard]] inline CellGradient tetrahedron_gradient(const std::array<Sample, 4>& samples) {
    const TetrahedronOf<double> cell(samples);
    if (!std::isfinite(cell.u + cell.v + cell.w)) return {};
    if (!cell.is_solid()) return stretched_tetrahedron_gradient(samples);
    const auto [x, y, z] = cell.gradient();
    return {{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}, absolute(cell.six_volumes) / 6};
}

// Returns the gradient and the volume of a standard cell. `samples`: one sample per corner, in the order of the shape.
// The function overwrites the samples.
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

} // namespace ciel::detail
