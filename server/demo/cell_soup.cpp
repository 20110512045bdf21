#include "demo/cell_soup.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace server::demo {
namespace {

constexpr double tolerance = 1e-9;
// Points of the lattice have different coordinates along this direction, so each point is compared with few others.
constexpr ciel::Vec3d generic_direction{0.57735026919, 0.32135, 0.75068};

double along(const ciel::Vec3d& p) {
    return p[0] * generic_direction[0] + p[1] * generic_direction[1] + p[2] * generic_direction[2];
}

bool same(const ciel::Vec3d& a, const ciel::Vec3d& b) {
    return std::abs(a[0] - b[0]) <= tolerance && std::abs(a[1] - b[1]) <= tolerance &&
           std::abs(a[2] - b[2]) <= tolerance;
}

std::vector<ciel::Index> representatives(const std::vector<ciel::Vec3d>& points) {
    std::vector<std::pair<double, ciel::Index>> order(points.size());
    for (ciel::Index i = 0; i < points.size(); ++i) order[i] = {along(points[i]), i};
    std::sort(order.begin(), order.end());
    std::vector<ciel::Index> result(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto [place, point] = order[i];
        result[point] = point;
        for (std::size_t j = i; j-- > 0 && place - order[j].first <= 2 * tolerance;)
            if (same(points[point], points[order[j].second])) {
                result[point] = result[order[j].second];
                break;
            }
    }
    return result;
}

} // namespace

void CellSoup::add(const CellSoup& other) {
    const auto points_before = static_cast<ciel::Index>(points.size());
    const std::uint64_t faces_before = face_offset.size() - 1, corners_before = face_point.size();
    points.insert(points.end(), other.points.begin(), other.points.end());
    cell_types.insert(cell_types.end(), other.cell_types.begin(), other.cell_types.end());
    for (std::size_t c = 1; c < other.cell_offset.size(); ++c)
        cell_offset.push_back(other.cell_offset[c] + faces_before);
    for (std::size_t f = 1; f < other.face_offset.size(); ++f)
        face_offset.push_back(other.face_offset[f] + corners_before);
    for (const ciel::Index point : other.face_point) face_point.push_back(point + points_before);
}

WeldedCells weld(const CellSoup& soup) {
    const std::vector<ciel::Index> representative = representatives(soup.points);
    WeldedCells welded;
    std::vector<ciel::Index> vertex(soup.points.size(), ciel::none);
    for (std::size_t i = 0; i < soup.points.size(); ++i) {
        if (representative[i] != i) continue;
        vertex[i] = static_cast<ciel::Index>(welded.positions.size() / 3);
        for (const double x : soup.points[i]) welded.positions.push_back(static_cast<float>(x));
    }
    welded.cell_types = soup.cell_types;
    for (std::size_t cell = 0; cell < soup.cell_types.size(); ++cell) {
        for (std::uint64_t face = soup.cell_offset[cell]; face < soup.cell_offset[cell + 1]; ++face) {
            const std::size_t begin = welded.face_vertex.size();
            for (std::uint64_t at = soup.face_offset[face]; at < soup.face_offset[face + 1]; ++at) {
                const ciel::Index v = vertex[representative[soup.face_point[at]]];
                if (welded.face_vertex.size() == begin || welded.face_vertex.back() != v)
                    welded.face_vertex.push_back(v);
            }
            while (welded.face_vertex.size() > begin + 1 && welded.face_vertex.back() == welded.face_vertex[begin])
                welded.face_vertex.pop_back();
            if (welded.face_vertex.size() < begin + 3)
                welded.face_vertex.resize(begin);
            else
                welded.face_offset.push_back(welded.face_vertex.size());
        }
        welded.cell_offset.push_back(welded.face_offset.size() - 1);
    }
    return welded;
}

} // namespace server::demo
