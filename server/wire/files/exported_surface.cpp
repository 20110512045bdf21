#include "wire/files/exported_surface.hpp"

#include "ciel/vectors.hpp"
#include "wire/bytes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>

namespace server::wire {
namespace {

constexpr double most_diagonals_away = 8; // farther from zero, floats are spaced by over 1e-6 of the diagonal

// Newell's normal is exactly zero for repeated points, and negligible for collinear points.
bool has_area(const ciel::Surface& surface, std::span<const ciel::Index> polygon) {
    if (polygon.size() < 3) return false;
    const ciel::Vec3f& base = surface.positions[polygon[0]];
    const auto relative = [&](ciel::Index vertex) {
        const ciel::Vec3f& p = surface.positions[vertex];
        return ciel::Vec3d{double{p[0]} - base[0], double{p[1]} - base[1], double{p[2]} - base[2]};
    };
    ciel::Vec3d normal{};
    double extent = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const ciel::Vec3d a = relative(polygon[i]);
        const ciel::Vec3d b = relative(polygon[i + 1]);
        for (std::size_t k = 0; k < 3; ++k)
            normal[k] += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
        extent = std::max({extent, ciel::dot(a, a), ciel::dot(b, b)});
    }
    return ciel::dot(normal, normal) > 1e-24 * extent * extent;
}

class Compactor {
public:
    explicit Compactor(const ciel::Surface& surface)
        : surface_(surface), local_(surface.positions.size(), ciel::none) {}

    void add(std::span<const ciel::Index> polygon) {
        distinct_.clear();
        for (const ciel::Index vertex : polygon)
            if (distinct_.empty() || distinct_.back() != vertex) distinct_.push_back(vertex);
        while (distinct_.size() > 1 && distinct_.front() == distinct_.back()) distinct_.pop_back();
        if (!has_area(surface_, distinct_)) return;
        for (const ciel::Index vertex : distinct_) {
            if (local_[vertex] == ciel::none) {
                local_[vertex] = static_cast<ciel::Index>(out_.vertices.size());
                out_.vertices.push_back(vertex);
            }
            out_.corner.push_back(local_[vertex]);
        }
        out_.offset.push_back(static_cast<ciel::Index>(out_.corner.size()));
    }
    ExportedPolygons take() { return std::move(out_); }

private:
    const ciel::Surface& surface_;
    std::vector<ciel::Index> local_, distinct_;
    ExportedPolygons out_;
};

} // namespace

void write_value(std::ostream& out, const NamedValues& values, ciel::Index vertex) {
    if (values.doubles)
        write_raw(out, values.values[vertex]);
    else
        write_raw(out, static_cast<float>(values.values[vertex]));
}

ciel::Vec3d file_origin(const std::array<double, 6>& bounds) {
    double farthest = 0;
    ciel::Vec3d extent{}, center{};
    for (std::size_t k = 0; k < 3; ++k) {
        farthest = std::max({farthest, std::abs(bounds[2 * k]), std::abs(bounds[2 * k + 1])});
        extent[k] = bounds[2 * k + 1] - bounds[2 * k];
        center[k] = std::round(bounds[2 * k] + extent[k] / 2);
    }
    if (farthest <= most_diagonals_away * std::sqrt(ciel::dot(extent, extent))) return {};
    return center;
}

std::string origin_text(ciel::Vec3d origin) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), "%.17g %.17g %.17g", origin[0], origin[1], origin[2]);
    return text.data();
}

ExportedPolygons exported_polygons(const ciel::Surface& surface, bool triangles) {
    Compactor compactor(surface);
    if (triangles) {
        const std::vector<ciel::Index> corners = ciel::triangulate(surface);
        for (std::size_t i = 0; i < corners.size(); i += 3) compactor.add(std::span(corners).subspan(i, 3));
        return compactor.take();
    }
    const std::span<const ciel::Index> all = surface.polygon_vertex;
    for (std::size_t i = 0; i + 1 < surface.polygon_offset.size(); ++i) {
        const ciel::Index begin = surface.polygon_offset[i];
        compactor.add(all.subspan(begin, surface.polygon_offset[i + 1] - begin));
    }
    return compactor.take();
}

} // namespace server::wire
