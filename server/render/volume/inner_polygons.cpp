#include "render/volume/inner_polygons.hpp"

#include "ciel/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numeric>

namespace server::render {
namespace {

constexpr int cells = 256;             // cells per side of the grid that covers the mesh in the plane of the slabs
constexpr double worth_splitting = 40; // triangles with a larger extent are split; unit: cells

glm::dvec3 vector_of(const ciel::Vec3d& v) { return {v[0], v[1], v[2]}; }
glm::dvec3 vector_of(const ciel::Vec3f& v) { return {v[0], v[1], v[2]}; }

// across(): distance along the slabs' normal. along(): two coordinates parallel to the slabs, in cells.
class Places {
public:
    Places(const Volume& volume) : across_(vector_of(volume.normal)) { // NOLINT(google-explicit-constructor)
        const glm::dvec3 other = std::abs(across_.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        along_[0] = glm::normalize(glm::cross(across_, other));
        along_[1] = glm::cross(across_, along_[0]);
        glm::dvec2 high(-1e300);
        low_ = glm::dvec2(1e300);
        for (const color::SlabVertex& vertex : volume.boundary->vertices) {
            const glm::dvec3 p = vector_of(vertex.position);
            const glm::dvec2 at(glm::dot(along_[0], p), glm::dot(along_[1], p));
            low_ = glm::min(low_, at);
            high = glm::max(high, at);
        }
        per_length_ = static_cast<double>(cells) / glm::max(high - low_, glm::dvec2(1e-300));
    }
    [[nodiscard]] double across(const glm::dvec3& p) const { return glm::dot(across_, p); }
    [[nodiscard]] glm::dvec2 along(const ciel::Vec3f& position) const {
        const glm::dvec3 p = vector_of(position);
        return (glm::dvec2(glm::dot(along_[0], p), glm::dot(along_[1], p)) - low_) * per_length_;
    }
    [[nodiscard]] glm::dvec2 cells_of(double length) const { return length * per_length_; }

private:
    glm::dvec3 across_;
    std::array<glm::dvec3, 2> along_;
    glm::dvec2 low_, per_length_;
};

struct Point {
    glm::dvec2 along;
    double across;
};

struct Box {
    glm::dvec2 low{1e300}, high{-1e300};
    void add(glm::dvec2 point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

int cell_of(double place) { return place > 0 ? static_cast<int>(std::min(place, cells - 1.0)) : 0; }

// Edge i joins the corners i and i + 1.
std::size_t longest_edge(const std::array<glm::dvec2, 3>& corners) {
    const auto length = [&](std::size_t i) { return glm::distance(corners[i], corners[(i + 1) % 3]); };
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (length(i) > length(longest)) longest = i;
    return longest;
}

class RowOfCells {
public:
    void mark(int first, int last) {
        for (int word = first / 64; word <= last / 64; ++word) words_[index(word)] |= bits(word, first, last);
    }
    [[nodiscard]] bool has_any(int first, int last) const {
        for (int word = first / 64; word <= last / 64; ++word)
            if ((words_[index(word)] & bits(word, first, last)) != 0) return true;
        return false;
    }
    void add(const RowOfCells& other) {
        for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
    }

private:
    static std::size_t index(int word) { return static_cast<std::size_t>(word); }
    static std::uint64_t bits(int word, int first, int last) {
        const int low = std::max(first - 64 * word, 0), high = std::min(last - 64 * word, 63);
        return (~std::uint64_t{0} << low) & (~std::uint64_t{0} >> (63 - high));
    }
    std::array<std::uint64_t, cells / 64> words_{};
};

// The set of grid cells in which a ray may meet the mesh's boundary within one slab.
class NearBoundary {
public:
    NearBoundary(const Places& places, double middle, double half)
        : places_(places), low_(middle - tolerance * half), high_(middle + tolerance * half),
          margin_(places.cells_of(widest_inner * half)) {}

    void add(const ciel::Vec3f& a, const ciel::Vec3f& b, const ciel::Vec3f& c) {
        Polygon piece{{point_of(a), point_of(b), point_of(c)}, 3};
        piece = piece.cut([this](const Point& point) { return point.across - low_; });
        piece = piece.cut([this](const Point& point) { return high_ - point.across; });
        for (std::size_t i = 0; i < piece.count; ++i)
            add_edge(piece.corners[i].along, piece.corners[(i + 1) % piece.count].along);
        for (int row = first_row_; row <= last_row_; ++row) {
            Span& span = spans_[index(row)];
            rows_[index(row)].mark(cell_of(span.low - margin_.x), cell_of(span.high + margin_.x));
            span = {};
        }
        first_row_ = cells;
        last_row_ = -1;
    }

    // Call after the last add(). Extends the marked cells by the margin in the direction across the rows.
    void finish() {
        const auto exact = rows_;
        const int reach = static_cast<int>(std::min(std::ceil(margin_.y), double{cells}));
        for (int row = 0; row < cells; ++row)
            for (int other = std::max(row - reach, 0); other <= std::min(row + reach, cells - 1); ++other)
                rows_[index(row)].add(exact[index(other)]);
    }

    [[nodiscard]] bool has_any(const Box& box) const {
        const int first = cell_of(box.low.x), last = cell_of(box.high.x), last_row = cell_of(box.high.y);
        for (int row = cell_of(box.low.y); row <= last_row; ++row)
            if (rows_[index(row)].has_any(first, last)) return true;
        return false;
    }

private:
    // Half of the slab's thickness is multiplied by this factor, to allow for rounding errors here and in the shaders.
    static constexpr double tolerance = 1.1;
    struct Span { // range of x in a row of cells
        double low = 1e300, high = -1e300;
    };
    struct Polygon { // a triangle cut by two planes
        std::array<Point, 5> corners;
        std::size_t count;

        template <class Height>
        [[nodiscard]] Polygon cut(const Height& height) const {
            Polygon kept{{}, 0};
            for (std::size_t i = 0; i < count; ++i) {
                const Point &from = corners[i], &to = corners[(i + 1) % count];
                const double a = height(from), b = height(to);
                if (a >= 0) kept.corners[kept.count++] = from;
                if ((a >= 0) == (b >= 0)) continue;
                const double share = a / (a - b);
                kept.corners[kept.count++] = {from.along + share * (to.along - from.along),
                                              from.across + share * (to.across - from.across)};
            }
            return kept;
        }
    };

    [[nodiscard]] Point point_of(const ciel::Vec3f& position) const {
        return {places_.along(position), places_.across(vector_of(position))};
    }
    static std::size_t index(int row) { return static_cast<std::size_t>(row); }

    void add_edge(glm::dvec2 from, glm::dvec2 to) {
        if (from.y > to.y) std::swap(from, to);
        const int first = cell_of(from.y), last = cell_of(to.y);
        const double slant = to.y > from.y ? (to.x - from.x) / (to.y - from.y) : 0;
        const auto add = [&](int row, double x) {
            Span& span = spans_[index(row)];
            span.low = std::min(span.low, x);
            span.high = std::max(span.high, x);
        };
        add(first, from.x);
        add(last, to.x);
        for (int row = first; row < last; ++row) {
            const double x = from.x + slant * (row + 1 - from.y);
            add(row, x);
            add(row + 1, x);
        }
        first_row_ = std::min(first_row_, first);
        last_row_ = std::max(last_row_, last);
    }

    const Places& places_;
    double low_, high_;
    glm::dvec2 margin_;
    std::array<RowOfCells, cells> rows_{};
    std::array<Span, cells> spans_; // range of x in each row, for the triangle that is being added
    int first_row_ = cells, last_row_ = -1;
};

class Sorter {
public:
    Sorter(const color::SlabTriangles& slice, const Places& places, const NearBoundary& near)
        : slice_(slice), near_(near) {
        sorted_.slice = &slice;
        sorted_.triangles.reserve(slice.triangles.size());
        inner_.reserve(slice.triangles.size());
        places_.reserve(slice.vertices.size());
        for (const color::SlabVertex& vertex : slice.vertices) places_.push_back(places.along(vertex.position));
    }

    SortedSlice sort() && {
        const std::vector<ciel::Index>& corners = slice_.triangles;
        for (std::size_t i = 0; i < corners.size(); i += 3) add({corners[i], corners[i + 1], corners[i + 2]});
        sorted_.outer = sorted_.triangles.size();
        sorted_.triangles.insert(sorted_.triangles.end(), inner_.begin(), inner_.end());
        return std::move(sorted_);
    }

private:
    using Triangle = std::array<ciel::Index, 3>;

    [[nodiscard]] const color::SlabVertex& vertex(ciel::Index i) const {
        return i < slice_.vertices.size() ? slice_.vertices[i] : sorted_.more[i - slice_.vertices.size()];
    }

    void add(const Triangle& triangle) {
        Box box;
        for (const ciel::Index corner : triangle) box.add(places_[corner]);
        if (!near_.has_any(box)) {
            inner_.insert(inner_.end(), triangle.begin(), triangle.end());
        } else if (const glm::dvec2 size = box.high - box.low; std::max(size.x, size.y) > worth_splitting) {
            split(triangle);
        } else {
            sorted_.triangles.insert(sorted_.triangles.end(), triangle.begin(), triangle.end());
        }
    }

    void split(const Triangle& triangle) {
        const std::size_t edge = longest_edge({places_[triangle[0]], places_[triangle[1]], places_[triangle[2]]});
        const ciel::Index a = triangle[edge], b = triangle[(edge + 1) % 3], c = triangle[(edge + 2) % 3];
        color::SlabVertex middle = halfway(vertex(a), vertex(b));
        middle.limits = vertex(triangle[0]).limits;
        const auto m = static_cast<ciel::Index>(slice_.vertices.size() + sorted_.more.size());
        sorted_.more.push_back(middle);
        places_.push_back(0.5 * (places_[a] + places_[b]));
        add({m, c, a});
        add({m, b, c});
    }

    static color::SlabVertex halfway(const color::SlabVertex& a, const color::SlabVertex& b) {
        color::SlabVertex middle{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            middle.position[axis] = std::midpoint(a.position[axis], b.position[axis]);
            middle.gradient[axis] = std::midpoint(a.gradient[axis], b.gradient[axis]);
        }
        middle.value = std::midpoint(a.value, b.value);
        return middle;
    }

    const color::SlabTriangles& slice_;
    const NearBoundary& near_;
    std::vector<glm::dvec2> places_; // coordinates of the vertices along the slabs, in cells
    SortedSlice sorted_;
    std::vector<ciel::Index> inner_;
};

} // namespace

std::vector<SortedSlice> sort_slices(const Volume& volume, std::span<const std::vector<ciel::Index>> boundary_of_slab) {
    std::vector<SortedSlice> out(boundary_of_slab.size());
    const Places places(volume);
    const double thickness = volume.thickness * static_cast<double>(volume.stride);
    ciel::parallel_for(out.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t slab = begin; slab < end; ++slab) {
            const std::size_t i = slab * volume.stride + volume.stride / 2;
            if (i >= volume.slices.size()) continue;
            const color::SlabTriangles& slice = volume.slices[i];
            const double middle = volume.first + (static_cast<double>(slab) + 0.5) * thickness;
            NearBoundary near(places, middle, thickness / 2);
            const std::vector<ciel::Index>& list = boundary_of_slab[slab];
            for (std::size_t k = 0; k < list.size(); k += 3)
                near.add(volume.boundary->vertices[list[k]].position, volume.boundary->vertices[list[k + 1]].position,
                         volume.boundary->vertices[list[k + 2]].position);
            near.finish();
            out[slab] = Sorter(slice, places, near).sort();
        }
    });
    return out;
}

} // namespace server::render
