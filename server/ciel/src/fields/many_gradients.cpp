// Gradients of four cells at once. A Four has one number per cell. least_squares repeats the operations of
// least_squares in cell_gradient.hpp in the same order, so that both give the same bits. The two share no template,
// because the function for one cell stores the components of one sample in a Four.
#include "fields/many_gradients.hpp"

#include "parallel/vector_units.hpp"

namespace ciel::detail {

namespace {

using FourSamples = SampleOf<Four>;

FourFlags finite(const Four& a) { return a - a == 0.0; }

FourSamples transposed(const Four& a, const Four& b, const Four& c, const Four& d) {
    const Four ab_even = even_interleaved(a, b), ab_odd = odd_interleaved(a, b);
    const Four cd_even = even_interleaved(c, d), cd_odd = odd_interleaved(c, d);
    return {first_halves(ab_even, cd_even), first_halves(ab_odd, cd_odd), last_halves(ab_even, cd_even),
            last_halves(ab_odd, cd_odd)};
}

struct FourGradients {
    Four x, y, z, volume;
    FourFlags good; // by cell: false if the cell must be solved alone
};

FourGradients gradients(const std::array<FourSamples, 4>& samples) {
    const TetrahedronOf<Four> cells(samples);
    const auto [x, y, z] = cells.gradient();
    return {x, y, z, absolute(cells.six_volumes) / 6.0, finite(cells.u + cells.v + cells.w) & cells.is_solid()};
}

template <const StandardShape& shape>
FourGradients least_squares(std::array<FourSamples, shape.corners>& samples) {
    FourSamples mean{};
    for (const FourSamples& s : samples) {
        mean.x += s.x;
        mean.y += s.y;
        mean.z += s.z;
        mean.value += s.value;
    }
    constexpr double share = 1.0 / static_cast<double>(shape.corners);
    mean = {mean.x * share, mean.y * share, mean.z * share, mean.value * share};
    FourVectors squares{}, products{}, slopes{};
    for (FourSamples& s : samples) {
        s = {s.x - mean.x, s.y - mean.y, s.z - mean.z, s.value - mean.value};
        squares[0] += s.x * s.x;
        squares[1] += s.y * s.y;
        squares[2] += s.z * s.z;
        products[0] += s.x * s.y;
        products[1] += s.y * s.z;
        products[2] += s.z * s.x;
        slopes[0] += s.x * s.value;
        slopes[1] += s.y * s.value;
        slopes[2] += s.z * s.value;
    }
    const NormalEquationsOf<Four> equations(squares[0], squares[1], squares[2], products[0], products[1], products[2]);
    const auto [x, y, z] = equations.gradient(slopes[0], slopes[1], slopes[2]);
    return {x, y, z, standard_volume<shape>(samples), finite(mean.value) & (equations.inverse_determinant > 0.0)};
}

template <const StandardShape& shape>
FourGradients gradients(std::array<FourSamples, shape.corners>& samples) {
    if constexpr (shape.type == CellType::tetrahedron)
        return gradients(samples);
    else
        return least_squares<shape>(samples);
}

template <const StandardShape& shape>
CellGradient one_gradient(const std::uint16_t* vertex, const Sample* sample) {
    std::array<Sample, shape.corners> samples;
    for (std::size_t c = 0; c < shape.corners; ++c) samples[c] = sample[vertex[c]];
    return standard_gradient<shape>(samples);
}

template <const StandardShape& shape>
void solve(const std::uint16_t* vertex, const Sample* sample, CellGradient* out) {
    std::array<FourSamples, shape.corners> samples;
    constexpr std::size_t n = shape.corners;
    for (std::size_t c = 0; c < n; ++c)
        samples[c] = transposed(load(sample[vertex[c]]), load(sample[vertex[n + c]]), load(sample[vertex[2 * n + c]]),
                                load(sample[vertex[3 * n + c]]));
    const FourGradients solved = gradients<shape>(samples);
    if (!all(solved.good)) {
        for (std::size_t i = 0; i < 4; ++i) out[i] = one_gradient<shape>(vertex + i * n, sample);
        return;
    }
    const FourFloats x = to_floats(solved.x), y = to_floats(solved.y), z = to_floats(solved.z);
    for (std::size_t i = 0; i < 4; ++i) out[i] = {{x[i], y[i], z[i]}, solved.volume[i]};
}

template <const StandardShape& shape>
void solve_all(const std::uint16_t* vertex, const Sample* sample, CellGradient* out, std::size_t cells) {
    std::size_t i = 0;
    for (; i + 4 <= cells; i += 4) solve<shape>(vertex + i * shape.corners, sample, out + i);
    for (; i < cells; ++i) out[i] = one_gradient<shape>(vertex + i * shape.corners, sample);
}

} // namespace

// All called functions are inlined (flatten), so that they are compiled for the same vector units.
[[gnu::flatten]] CIEL_FOR_ALL_VECTOR_UNITS void solve_tetrahedra(const std::uint16_t* vertex, const Sample* sample,
                                                                 CellGradient* out, std::size_t cells) {
    solve_all<tetrahedron_shape>(vertex, sample, out, cells);
}
[[gnu::flatten]] CIEL_FOR_ALL_VECTOR_UNITS void solve_hexahedra(const std::uint16_t* vertex, const Sample* sample,
                                                                CellGradient* out, std::size_t cells) {
    solve_all<hexahedron_shape>(vertex, sample, out, cells);
}
[[gnu::flatten]] CIEL_FOR_ALL_VECTOR_UNITS void solve_wedges(const std::uint16_t* vertex, const Sample* sample,
                                                             CellGradient* out, std::size_t cells) {
    solve_all<wedge_shape>(vertex, sample, out, cells);
}
[[gnu::flatten]] CIEL_FOR_ALL_VECTOR_UNITS void solve_pyramids(const std::uint16_t* vertex, const Sample* sample,
                                                               CellGradient* out, std::size_t cells) {
    solve_all<pyramid_shape>(vertex, sample, out, cells);
}

void many_gradients(CellType type, std::span<const std::uint16_t> vertex, std::span<const Sample> sample,
                    std::span<CellGradient> out) {
    const auto solve = type == CellType::tetrahedron  ? solve_tetrahedra
                       : type == CellType::hexahedron ? solve_hexahedra
                       : type == CellType::wedge      ? solve_wedges
                                                      : solve_pyramids;
    solve(vertex.data(), sample.data(), out.data(), out.size());
}

} // namespace ciel::detail
