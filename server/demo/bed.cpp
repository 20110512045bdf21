#include "demo/bed.hpp"

#include <algorithm>
#include <cmath>

namespace server::demo {
namespace {

// Appends `count` planes. The distance from the last plane to the first new plane is step * growth.
void widen(std::vector<double>& planes, double step, double growth, int count) {
    for (int n = 0; n < count; ++n) planes.push_back(planes.back() + (step *= growth));
}

std::vector<double> axis(double low, double step, int before, double growth_before, int count, int after,
                         double growth_after) {
    std::vector<double> planes{low};
    widen(planes, -step, growth_before, before);
    std::reverse(planes.begin(), planes.end());
    for (int n = 1; n <= count; ++n) planes.push_back(low + n * step);
    widen(planes, step, growth_after, after);
    return planes;
}

constexpr double finest = 0.12;
constexpr int upstream = 10, near_x = 73, downstream = 35;
constexpr int beside = 10, near_y = 40;
constexpr int layers = 40;
constexpr double growth_around = 1.15, growth_downstream = 1.04;

} // namespace

Bed::Bed(int coarseness) : spacing(finest * coarseness) {
    // Rounds to the nearest integer, and down if the fraction is one half.
    const auto cells = [&](int finest_cells) { return (2 * finest_cells + coarseness - 1) / (2 * coarseness); };
    const double around = std::pow(growth_around, coarseness), behind = std::pow(growth_downstream, coarseness);
    x = axis(-2.4, spacing, cells(upstream), around, cells(near_x), cells(downstream), behind);
    y = axis(-2.4, spacing, cells(beside), around, cells(near_y), cells(beside), around);
    z = axis(0, spacing, 0, 1, cells(layers), 0, 1);
    x_begin = static_cast<std::size_t>(cells(upstream));
    x_end = x_begin + static_cast<std::size_t>(cells(near_x));
    y_begin = static_cast<std::size_t>(cells(beside));
    y_end = y_begin + static_cast<std::size_t>(cells(near_y));
}

CellSoup hexahedra(const Bed& bed) {
    CellSoup soup;
    for (const double z : bed.z)
        for (const double y : bed.y)
            for (const double x : bed.x) soup.points.push_back({x, y, z});
    const auto point = [&](std::size_t i, std::size_t j, std::size_t k) {
        return static_cast<ciel::Index>(i + bed.x.size() * (j + bed.y.size() * k));
    };
    for (std::size_t k = 0; k + 1 < bed.z.size(); ++k)
        for (std::size_t j = 0; j + 1 < bed.y.size(); ++j)
            for (std::size_t i = 0; i + 1 < bed.x.size(); ++i) {
                if (bed.is_voronoi(i, j)) continue;
                const std::array corners{
                    point(i, j, k),     point(i + 1, j, k),     point(i + 1, j + 1, k),     point(i, j + 1, k),
                    point(i, j, k + 1), point(i + 1, j, k + 1), point(i + 1, j + 1, k + 1), point(i, j + 1, k + 1)};
                ciel::append_standard_faces(ciel::CellType::hexahedron, corners, soup.face_offset, soup.face_point);
                soup.cell_types.push_back(static_cast<std::uint8_t>(ciel::CellType::hexahedron));
                soup.cell_offset.push_back(soup.face_offset.size() - 1);
            }
    return soup;
}

} // namespace server::demo
