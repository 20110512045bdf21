#include "oracle/kernel_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

namespace ciel::test {

std::vector<float> KernelMesh::stored(std::span<const float> input_values) const {
    std::vector<float> values;
    for (Index v : assembled.original_vertex) values.push_back(input_values[v]);
    return values;
}

Cut KernelMesh::cut(const Surface& surface) const {
    std::vector<CutEdge> edges;
    for (const EdgePoint& point : surface.points) {
        edges.push_back(std::minmax(assembled.original_vertex[point.a], assembled.original_vertex[point.b]));
    }
    Cut cut{{edges.begin(), edges.end()}, {}};
    for (std::size_t p = 0; p < surface.polygon_cell.size(); ++p) {
        CutPolygon result{assembled.original_cell[surface.polygon_cell[p]], {}};
        for (Index v : polygon(surface, p)) result.edges.push_back(edges[v]);
        if (make_canonical(result)) cut.polygons.push_back(std::move(result));
    }
    std::sort(cut.polygons.begin(), cut.polygons.end());
    return cut;
}

Field make_field(const Topology& topology, std::vector<float> stored_values) {
    const auto values = std::make_shared<const std::vector<float>>(std::move(stored_values));
    return {topology, *values, values};
}

std::span<const Index> polygon(const Surface& surface, std::size_t index) {
    const Index begin = surface.polygon_offset[index], end = surface.polygon_offset[index + 1];
    return std::span(surface.polygon_vertex).subspan(begin, end - begin);
}

Surface only(const Surface& all, const std::vector<Index>& blocks) {
    Surface some;
    std::vector<Index> kept(all.points.size(), none);
    for (const Surface::Chunk& chunk : all.chunks) {
        if (!std::ranges::binary_search(blocks, chunk.block)) continue;
        const auto begin = static_cast<Index>(some.polygon_cell.size());
        for (Index i = chunk.polygon_begin; i < chunk.polygon_end; ++i) {
            for (const Index p : polygon(all, i)) {
                some.polygon_vertex.push_back(p);
                kept[p] = 0;
            }
            some.polygon_offset.push_back(static_cast<Index>(some.polygon_vertex.size()));
            some.polygon_cell.push_back(all.polygon_cell[i]);
        }
        some.chunks.push_back({chunk.block, begin, static_cast<Index>(some.polygon_cell.size())});
    }
    for (std::size_t p = 0; p < kept.size(); ++p) {
        if (kept[p] == none) continue;
        kept[p] = static_cast<Index>(some.points.size());
        some.points.push_back(all.points[p]);
        some.positions.push_back(all.positions[p]);
        if (!all.normals.empty()) some.normals.push_back(all.normals[p]);
    }
    for (Index& p : some.polygon_vertex) p = kept[p];
    return some;
}

Vec3d vector_area(std::span<const Vec3f> positions, std::span<const Index> polygon) {
    Vec3d sum{};
    const auto arm = [&](std::size_t i) {
        const Vec3f &o = positions[polygon[0]], &p = positions[polygon[i]];
        return Vec3d{double(p[0]) - o[0], double(p[1]) - o[1], double(p[2]) - o[2]};
    };
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const Vec3d a = arm(i), b = arm(i + 1);
        for (std::size_t d = 0; d < 3; ++d)
            sum[d] += 0.5 * (a[(d + 1) % 3] * b[(d + 2) % 3] - a[(d + 2) % 3] * b[(d + 1) % 3]);
    }
    return sum;
}

namespace {

// Checks conditions and keeps the message of the first that fails.
class Promises {
public:
    template <typename... Words>
    bool check(bool kept, const Words&... words) {
        if (!kept && text_.str().empty()) (text_ << ... << words);
        return kept;
    }
    [[nodiscard]] std::string broken() const { return text_.str(); }

private:
    std::ostringstream text_;
};

void check_polygons(const Surface& surface, const KernelMesh& mesh, Promises& promises) {
    const std::size_t polygons = surface.polygon_cell.size();
    if (!promises.check(surface.polygon_offset.size() == polygons + 1, "polygon_offset is not polygons + 1")) return;
    promises.check(surface.polygon_offset[0] == 0 && surface.polygon_offset.back() == surface.polygon_vertex.size(),
                   "polygon_offset does not span polygon_vertex");
    promises.check(std::is_sorted(surface.polygon_cell.begin(), surface.polygon_cell.end()),
                   "polygons are not in storage order of their cells");
    for (std::size_t p = 0; p < polygons; ++p) {
        if (!promises.check(surface.polygon_offset[p + 1] >= surface.polygon_offset[p] + 3, "polygon ", p,
                            " has fewer than three vertices"))
            return;
        promises.check(surface.polygon_cell[p] < mesh.mesh().cell_count(), "polygon ", p, " names no cell");
        for (Index v : polygon(surface, p))
            promises.check(v < surface.points.size(), "polygon ", p, " names no vertex");
    }
    Index next = 0;
    Index block = 0;
    for (const Surface::Chunk& chunk : surface.chunks) {
        promises.check(chunk.polygon_begin == next && chunk.polygon_end >= chunk.polygon_begin, "chunks leave a gap");
        promises.check(chunk.block < mesh.topology.block_count() && (next == 0 || chunk.block > block),
                       "chunks are not in order of blocks");
        next = chunk.polygon_end;
        block = chunk.block;
    }
    promises.check(next == polygons, "chunks do not cover the polygons");
    const std::set<Index> used(surface.polygon_vertex.begin(), surface.polygon_vertex.end());
    promises.check(used.size() == surface.points.size(), "a vertex belongs to no polygon");
}

void check_points(const Surface& surface, const KernelMesh& mesh, std::span<const float> stored, double nu,
                  Promises& promises) {
    std::set<std::pair<Index, Index>> seen;
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        const auto [a, b, t] = surface.points[i];
        if (!promises.check(a < b && b < mesh.mesh().vertex_count(), "point ", i, " names no edge")) return;
        promises.check(seen.emplace(a, b).second, "edge ", a, "-", b, " has two points");
        const double low = stored[a], high = stored[b];
        promises.check((low >= nu) != (high >= nu), "edge ", a, "-", b, " is not active");
        promises.check(t >= 0 && t <= 1, "t leaves [0, 1] on edge ", a, "-", b);
        promises.check(std::abs(t - (nu - low) / (high - low)) < 1e-6, "t is wrong on edge ", a, "-", b);
        for (std::size_t d = 0; d < 3; ++d) {
            const double pa = mesh.mesh().positions[3 * a + d], pb = mesh.mesh().positions[3 * b + d];
            const double tolerance = 1e-6 * (std::abs(pa) + std::abs(pb) + 1e-30);
            promises.check(std::abs(pa + t * (pb - pa) - surface.positions[i][d]) <= tolerance, "point ", i,
                           " is off its edge");
        }
    }
}

} // namespace

std::string broken_promise(const Surface& surface, const KernelMesh& mesh, std::span<const float> stored, double nu,
                           bool normals) {
    Promises promises;
    promises.check(surface.positions.size() == surface.points.size(), "as many positions as points");
    promises.check(surface.normals.size() == (normals ? surface.points.size() : 0), "as many normals as asked for");
    if (!promises.broken().empty()) return promises.broken();
    check_points(surface, mesh, stored, nu, promises);
    check_polygons(surface, mesh, promises);
    for (const Vec3f& n : surface.normals) {
        const double length = std::hypot(n[0], n[1], n[2]);
        promises.check(std::abs(length - 1) < 1e-4 || length == 0, "a normal of length ", length);
    }
    return promises.broken();
}

namespace {

template <typename T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    static_assert(std::is_trivially_copyable_v<T>);
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

} // namespace

std::string bit_difference(const Surface& a, const Surface& b, Chunks chunks) {
    if (!same_bits(a.points, b.points)) return "points";
    if (!same_bits(a.positions, b.positions)) return "positions";
    if (!same_bits(a.normals, b.normals)) return "normals";
    if (!same_bits(a.polygon_offset, b.polygon_offset)) return "polygon_offset";
    if (!same_bits(a.polygon_vertex, b.polygon_vertex)) return "polygon_vertex";
    if (!same_bits(a.polygon_cell, b.polygon_cell)) return "polygon_cell";
    if (chunks == Chunks::compare && !same_bits(a.chunks, b.chunks)) return "chunks";
    return {};
}

} // namespace ciel::test
