#include <utility>
#include <voro++/voro++.hh>

#include "demo/bed.hpp"

#include "ciel/parallel.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace server::demo {
namespace {

struct Seeds {
    std::vector<ciel::Vec3d> real, images; // `images` lie inside the cylinder, shape the wall, and get no cells
};

void add_lattice_seeds(const Bed& bed, Seeds& seeds) {
    // Largest shift of a seed, in spacings. It makes the cells irregular, and is small enough to avoid slivers.
    constexpr double shift = 0.35;
    const double h = bed.spacing, clear_radius = 1 + 1.2 * h;
    std::mt19937_64 random(1);
    const auto jitter = [&] { return shift * h * (static_cast<double>(random()) / 0x1p63 - 1); };
    for (std::size_t k = 0; k + 1 < bed.z.size(); ++k)
        for (std::size_t j = bed.y_begin; j < bed.y_end; ++j)
            for (std::size_t i = bed.x_begin; i < bed.x_end; ++i) {
                ciel::Vec3d seed{(bed.x[i] + bed.x[i + 1]) / 2, (bed.y[j] + bed.y[j + 1]) / 2,
                                 (bed.z[k] + bed.z[k + 1]) / 2};
                const bool outermost = i == bed.x_begin || i + 1 == bed.x_end || j == bed.y_begin || j + 1 == bed.y_end;
                if (!outermost)
                    for (double& x : seed) x += jitter();
                if (std::hypot(seed[0], seed[1]) > clear_radius) seeds.real.push_back(seed);
            }
}

void add_ring_seeds(const Bed& bed, Seeds& seeds) {
    const int around = static_cast<int>(std::lround(2 * std::numbers::pi * (1 + bed.spacing / 2) / bed.spacing));
    // Faces between seeds and their images touch this circle, so that the edges of the faces lie on the cylinder.
    const double mirror = std::cos(std::numbers::pi / around), half = bed.spacing / 2;
    for (std::size_t k = 0; k + 1 < bed.z.size(); ++k)
        for (int n = 0; n < around; ++n) {
            const double angle = 2 * std::numbers::pi * n / around, z = (bed.z[k] + bed.z[k + 1]) / 2;
            const double c = std::cos(angle), s = std::sin(angle);
            seeds.real.push_back({(mirror + half) * c, (mirror + half) * s, z});
            seeds.images.push_back({(mirror - half) * c, (mirror - half) * s, z});
        }
}

// Moves corners to the sides of the box, because voro++ rounds corners and patch_of() compares exact coordinates.
void snap(ciel::Vec3d& p, const std::array<ciel::Vec3d, 2>& box) {
    for (const ciel::Vec3d& corner : box)
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (std::abs(p[axis] - corner[axis]) < 1e-9) p[axis] = corner[axis];
}

void append_cell(voro::voronoicell& cell, const ciel::Vec3d& seed, const std::array<ciel::Vec3d, 2>& box,
                 CellSoup& soup) {
    std::vector<double> corners;
    std::vector<int> faces; // for each face: the number of corners, then the corners
    cell.vertices(seed[0], seed[1], seed[2], corners);
    cell.face_vertices(faces);
    const auto first = static_cast<ciel::Index>(soup.points.size());
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        soup.points.push_back({corners[i], corners[i + 1], corners[i + 2]});
        snap(soup.points.back(), box);
    }
    for (std::size_t at = 0; at < faces.size();) {
        const auto count = static_cast<std::size_t>(faces[at]);
        for (std::size_t corner = count; corner > 0; --corner) // in reverse order, because voro++ winds faces inwards
            soup.face_point.push_back(first + static_cast<ciel::Index>(faces[at + corner]));
        soup.face_offset.push_back(soup.face_point.size());
        at += count + 1;
    }
    soup.cell_types.push_back(static_cast<std::uint8_t>(ciel::CellType::polyhedron));
    soup.cell_offset.push_back(soup.face_offset.size() - 1);
}

// Each call makes its own voro++ container, because a container is not thread-safe.
CellSoup cells_of(const Bed& bed, const Seeds& seeds, std::size_t begin, std::size_t end) {
    constexpr double seeds_per_block = 5; // as voro++ recommends
    const double block = bed.spacing * std::cbrt(seeds_per_block);
    const auto blocks = [&](double from, double to) { return std::max(1, static_cast<int>((to - from) / block)); };
    const std::array<ciel::Vec3d, 2> box{ciel::Vec3d{bed.x[bed.x_begin], bed.y[bed.y_begin], bed.z.front()},
                                         ciel::Vec3d{bed.x[bed.x_end], bed.y[bed.y_end], bed.z.back()}};
    const auto& [low, high] = box;
    voro::container container(low[0], high[0], low[1], high[1], low[2], high[2], blocks(low[0], high[0]),
                              blocks(low[1], high[1]), blocks(low[2], high[2]), false, false, false, 8);
    voro::particle_order wanted;
    int id = 0;
    for (const ciel::Vec3d& p : seeds.real) {
        const auto index = static_cast<std::size_t>(id);
        if (index >= begin && index < end)
            container.put(wanted, id, p[0], p[1], p[2]);
        else
            container.put(id, p[0], p[1], p[2]);
        ++id;
    }
    for (const ciel::Vec3d& p : seeds.images) container.put(id++, p[0], p[1], p[2]);

    CellSoup soup;
    voro::c_loop_order loop(container, wanted);
    voro::voronoicell cell;
    if (!loop.start()) return soup;
    do
        if (container.compute_cell(cell, loop))
            append_cell(cell, seeds.real[static_cast<std::size_t>(loop.pid())], box, soup);
    while (loop.inc());
    return soup;
}

} // namespace

CellSoup voronoi_cells(const Bed& bed) {
    Seeds seeds;
    add_lattice_seeds(bed, seeds);
    add_ring_seeds(bed, seeds);
    constexpr std::size_t parts = 8; // constant, so that the cells do not depend on the number of threads
    std::vector<CellSoup> soups(parts);
    ciel::parallel_for(parts, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end; ++part)
            soups[part] =
                cells_of(bed, seeds, seeds.real.size() * part / parts, seeds.real.size() * (part + 1) / parts);
    });
    CellSoup all;
    for (const CellSoup& soup : soups) all.add(soup);
    return all;
}

} // namespace server::demo
