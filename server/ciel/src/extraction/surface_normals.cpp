// Makes normals at points from the polygons around the points. Replaces gradient normals that cannot be used.
#include "extraction/polygon.hpp"
#include "extraction/surface_writer.hpp"
#include "parallel/grain.hpp"

#include <algorithm>
#include <atomic>

namespace ciel::detail {

namespace {

bool is_zero(const Vec3f& v) { return v == Vec3f{}; }

// In flat cells at a wall, the least-squares gradient of a cell and the surface in the cell may disagree.
void mark_doubtful(const Surface& surface, std::vector<std::uint8_t>& doubtful) {
    doubtful.assign(surface.points.size(), 0);
    parallel_for(surface.polygon_cell.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::span<const Index> loop = polygon(surface, i);
            const Vec3d area = area_vector(surface.positions, loop);
            for (const Index p : loop)
                if (is_zero(surface.normals[p]) || dot(surface.normals[p], area) < 0)
                    std::atomic_ref(doubtful[p]).store(1, std::memory_order_relaxed);
        }
    });
}

} // namespace

std::size_t SurfaceScratch::memory_bytes() const {
    std::size_t bytes = ranges.capacity() * sizeof(PointRange) + sum.capacity() * sizeof(Vec3d) + doubtful.capacity() +
                        renumbered.capacity() * sizeof(Index) + adopted.memory_bytes() +
                        elsewhere.capacity() * sizeof(std::vector<Share>);
    for (const auto& shares : elsewhere) bytes += shares.capacity() * sizeof(Share);
    return bytes;
}

// Sums in the order of the polygons, so that the normals have the same bits for any ranges.
void write_polygon_normals(SurfaceScratch& scratch, Surface& surface) {
    const std::span<const PointRange> ranges = scratch.ranges;
    std::vector<Vec3d>& sum = scratch.sum;
    std::vector<std::vector<SurfaceScratch::Share>>& elsewhere = scratch.elsewhere;
    sum.assign(surface.points.size(), {});
    if (elsewhere.size() < ranges.size()) elsewhere.resize(ranges.size());
    for (std::vector<SurfaceScratch::Share>& shares : elsewhere) shares.clear();
    const auto add = [&sum](Index point, const Vec3d& area) {
        for (std::size_t axis = 0; axis < 3; ++axis) sum[point][axis] += area[axis];
    };
    parallel_for(ranges.size(), fair_grain(ranges.size(), 4), [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c)
            for (Index i = ranges[c].polygon_begin; i < ranges[c].polygon_end; ++i) {
                const std::span<const Index> loop = polygon(surface, i);
                const Vec3d area = area_vector(surface.positions, loop);
                for (const Index p : loop)
                    if (p >= ranges[c].point_begin && p < ranges[c].point_end)
                        add(p, area);
                    else
                        elsewhere[c].push_back({p, area});
            }
    });
    // The tasks are large, because each task reads all recorded shares.
    const std::size_t points_per_task = std::clamp<std::size_t>(sum.size() / (2 * thread_count()), 1024, 65536);
    parallel_for(sum.size(), points_per_task, [&](std::size_t begin, std::size_t end) {
        for (const std::vector<SurfaceScratch::Share>& shares : elsewhere)
            for (const SurfaceScratch::Share& share : shares)
                if (share.point >= begin && share.point < end) add(share.point, share.area);
        for (std::size_t p = begin; p < end; ++p) surface.normals[p] = unit(sum[p]);
    });
}

void mend_normals(SurfaceScratch& scratch, Surface& surface) {
    const std::vector<std::uint8_t>& doubtful = scratch.doubtful;
    mark_doubtful(surface, scratch.doubtful);
    if (std::ranges::none_of(doubtful, [](std::uint8_t flag) { return flag != 0; })) return;
    std::vector<Vec3d>& sum = scratch.sum;
    sum.assign(surface.points.size(), {});
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        const std::span<const Index> loop = polygon(surface, i);
        if (std::ranges::none_of(loop, [&](Index p) { return doubtful[p] != 0; })) continue;
        const Vec3d area = area_vector(surface.positions, loop);
        for (const Index p : loop)
            for (std::size_t axis = 0; axis < 3; ++axis) sum[p][axis] += area[axis];
    }
    for (std::size_t p = 0; p < sum.size(); ++p)
        if (doubtful[p] != 0 && (is_zero(surface.normals[p]) || dot(surface.normals[p], sum[p]) < 0))
            surface.normals[p] = unit(sum[p]);
}

} // namespace ciel::detail
