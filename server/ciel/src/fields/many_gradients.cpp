// Does the operations of cell_gradient.hpp in the same order for four cells at once. A vector has one number per cell.
#include "fields/many_gradients.hpp"

#include "parallel/vector_units.hpp"

namespace ciel {

namespace {

using FourFloats = float __attribute__((vector_size(16)));
using FourFlags = decltype(Four{} > Four{});

struct FourSamples {
    Four x, y, z, value;
};
struct FourVectors {
    Four x, y, z;
};

FourVectors arm(const FourSamples& from, const FourSamples& to) {
    return {to.x - from.x, to.y - from.y, to.z - from.z};
}
FourVectors cross(const FourVectors& a, const FourVectors& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Four dot(const FourVectors& a, const FourVectors& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Four absolute(const Four& a) { return a < 0.0 ? -a : a; }
FourFlags finite(const Four& a) { return a - a == 0.0; }
bool all(const FourFlags& flags) { return (flags[0] & flags[1] & flags[2] & flags[3]) != 0; }

FourSamples transposed(const Four& a, const Four& b, const Four& c, const Four& d) {
    const Four ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Four cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    return {__builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5), __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5),
            __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7), __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7)};
}

struct FourGradients {
    Four x, y, z, volume;
    FourFlags good; // by cell: false if the cell must be solved alone
};

FourGradients gradients(const std::array<FourSamples, 4>& samples) {
    const FourVectors a = arm(samples[0], samples[1]), b = arm(samples[0], samples[2]), c = arm(samples[0], samples[3]);
    const FourVectors bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const Four six_volumes = dot(a, bc);
    Four size = a.x * a.x + b.x * b.x + c.x * c.x;
    size += a.y * a.y + b.y * b.y + c.y * c.y;
    size += a.z * a.z + b.z * b.z + c.z * c.z;
    const Four u = samples[1].value - samples[0].value, v = samples[2].value - samples[0].value,
               w = samples[3].value - samples[0].value;
    const Four share = 1.0 / six_volumes;
    return {(u * bc.x + v * ca.x + w * ab.x) * share, (u * bc.y + v * ca.y + w * ab.y) * share,
            (u * bc.z + v * ca.z + w * ab.z) * share, absolute(six_volumes) / 6.0,
            finite(u + v + w) & (six_volumes * six_volumes > 1e-12 * size * size * size)};
}

template <const StandardShape& shape>
Four volumes(const std::array<FourSamples, shape.corners>& samples) {
    Four six_volumes{};
    for (std::size_t face = 0; face < shape.faces; ++face) {
        const std::size_t h = shape.face_begin[face];
        const FourSamples &a = samples[shape.origin[h]], &b = samples[shape.origin[h + 1]],
                          &c = samples[shape.origin[h + 2]];
        const FourVectors area = shape.face_size(face) == 3 ? cross(arm(a, b), arm(a, c))
                                                            : cross(arm(a, c), arm(b, samples[shape.origin[h + 3]]));
        six_volumes += dot({a.x, a.y, a.z}, area);
    }
    return absolute(six_volumes) / 6.0;
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
        squares.x += s.x * s.x;
        squares.y += s.y * s.y;
        squares.z += s.z * s.z;
        products.x += s.x * s.y;
        products.y += s.y * s.z;
        products.z += s.z * s.x;
        slopes.x += s.x * s.value;
        slopes.y += s.y * s.value;
        slopes.z += s.z * s.value;
    }
    const NormalEquationsOf<Four> equations(squares.x, squares.y, squares.z, products.x, products.y, products.z);
    const auto [x, y, z] = equations.gradient(slopes.x, slopes.y, slopes.z);
    return {x, y, z, volumes<shape>(samples), finite(mean.value) & (equations.inverse_determinant > 0.0)};
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
    const auto x = __builtin_convertvector(solved.x, FourFloats), y = __builtin_convertvector(solved.y, FourFloats),
               z = __builtin_convertvector(solved.z, FourFloats);
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

} // namespace ciel
