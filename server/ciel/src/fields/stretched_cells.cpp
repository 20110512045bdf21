// Least-squares gradient in stretched cells by modified Gram-Schmidt. Normal equations would square the condition
// number, which grows with the aspect ratio. The value column is orthogonalized, too, so that no product uses numbers
// that lost precision by cancellation. Source: A. Bjorck, Solving linear least squares problems by Gram-Schmidt
// orthogonalization, BIT 7 (1967).
#include "fields/cell_gradient.hpp"

namespace ciel::detail {

namespace {

using Row = std::array<double, 4>; // x, y, z, value

Row row_of(const Sample& s) { return {s.x, s.y, s.z, s.value}; }
Sample sample_of(const Row& r) { return {r[0], r[1], r[2], r[3]}; }

Row products(std::span<const Sample> samples, std::size_t column) {
    Row sum{};
    for (const Sample& sample : samples) {
        const Row row = row_of(sample);
        for (std::size_t k = column; k < row.size(); ++k) sum[k] += row[column] * row[k];
    }
    return sum;
}

void shear(std::span<Sample> samples, std::size_t column, const Row& share) {
    for (Sample& sample : samples) {
        Row row = row_of(sample);
        for (std::size_t k = column + 1; k < row.size(); ++k) row[k] -= row[column] * share[k];
        sample = sample_of(row);
    }
}

} // namespace

bool fit_stretched(std::span<Sample> samples, const Sample& mean, Vec3f& gradient) {
    double squares = 0; // sum of the squares of the samples and of their mean; rounding grows with both
    for (const Sample& s : samples) squares += s.x * s.x + s.y * s.y + s.z * s.z;
    squares += static_cast<double>(samples.size()) * (mean.x * mean.x + mean.y * mean.y + mean.z * mean.z);
    const double rounding = 1e-28 * squares;
    std::array<Row, 3> share{};
    for (std::size_t column = 0; column < 3; ++column) {
        share[column] = products(samples, column);
        const double square = share[column][column];
        if (!(square > rounding)) return false;
        for (double& x : share[column]) x /= square;
        shear(samples, column, share[column]);
    }
    const double z = share[2][3], y = share[1][3] - share[1][2] * z;
    const double x = share[0][3] - share[0][1] * y - share[0][2] * z;
    gradient = {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    return true;
}

CellGradient stretched_tetrahedron_gradient(std::array<Sample, 4> samples) {
    Row mean{};
    for (const Sample& s : samples)
        for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += row_of(s)[k] / 4;
    for (Sample& s : samples) s = {s.x - mean[0], s.y - mean[1], s.z - mean[2], s.value - mean[3]};
    CellGradient out;
    if (!fit_stretched(samples, sample_of(mean), out.gradient)) return {};
    const Vec3d a = arm(samples[0], samples[1]), b = arm(samples[0], samples[2]), c = arm(samples[0], samples[3]);
    out.volume = std::abs(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                          a[2] * (b[0] * c[1] - b[1] * c[0])) /
                 6;
    return out;
}

} // namespace ciel::detail
