#include "oracle/vectors/gradient_bits.hpp"

#include "fields/many_gradients.hpp"
#include "fields/polyhedron_gradient.hpp"
#include "oracle/random_cells.hpp"

#include <bit>

namespace ciel::test {

using namespace ciel::detail;

namespace {

constexpr std::size_t cells = 4099, cells_per_sum = 8;

class Bits {
public:
    void add(const CellGradient& cell) {
        add(cell.gradient);
        add(cell.volume);
        sum_.add(cell);
    }
    void end_sum() {
        add(sum_.mean());
        sum_ = {};
    }
    std::vector<std::uint64_t> all;

private:
    void add(double number) { all.push_back(std::bit_cast<std::uint64_t>(number)); }
    void add(const Vec3f& vector) {
        for (const float x : vector) add(double{x});
    }

    GradientSum sum_;
};

// A block of one polyhedron that has the faces of a standard cell.
template <const StandardShape& shape>
class Polyhedron {
public:
    Polyhedron() {
        for (std::size_t h = 0; h < shape.half_edges; ++h) vertex_.push_back(shape.origin[h]);
        for (std::uint16_t face = 0; face <= shape.faces; ++face) face_begin_.push_back(shape.face_begin[face]);
        for (std::uint16_t face = 0; face < shape.faces; ++face) cell_face_.push_back(2 * face);
        section_.vertex = vertex_;
        section_.face_begin = face_begin_;
        section_.cell_face_begin = cell_face_begin_;
        section_.cell_face = cell_face_;
        block_.vertex_count = shape.corners;
        block_.cell_count = 1;
    }
    // `sample`: returns the Sample of a corner.
    template <class Sampler>
    [[nodiscard]] CellGradient gradient(const Sampler& sample) {
        fitter_.begin(block_, section_);
        return fitted_gradient(fitter_.fit(section_, 0, sample), sample, scratch_);
    }

private:
    std::vector<std::uint16_t> vertex_, face_begin_, cell_face_begin_{0, shape.faces}, cell_face_;
    PolyhedralSection<std::uint16_t> section_;
    Block block_;
    PolyhedronFitter fitter_;
    std::vector<Sample> scratch_;
};

template <const StandardShape& shape>
std::vector<std::uint64_t> bits_of_cells() {
    RandomCells random;
    for (std::size_t i = 0; i < cells; ++i) random.put_cell(shape.corners);
    std::vector<CellGradient> four_at_once(cells);
    many_gradients(shape.type, random.vertex, random.samples, four_at_once);
    Polyhedron<shape> polyhedron;
    Bits bits;
    for (std::size_t i = 0; i < cells; ++i) {
        const std::uint16_t* vertex = &random.vertex[i * shape.corners];
        bits.add(four_at_once[i]);
        bits.add(cell_gradient<shape>(vertex, [&](Index v) { return random.samples[v]; }));
        bits.add(polyhedron.gradient([&](Index corner) { return random.samples[vertex[corner]]; }));
        if (i % cells_per_sum == 0) bits.end_sum();
    }
    return bits.all;
}

} // namespace

std::vector<std::uint64_t> gradient_bits(std::uint8_t type) {
    std::vector<std::uint64_t> bits;
    (void)with_shape(static_cast<CellType>(type),
                     [&]<const StandardShape & shape>() { bits = bits_of_cells<shape>(); });
    return bits;
}

} // namespace ciel::test
