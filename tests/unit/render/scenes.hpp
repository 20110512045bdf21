// Shapes and frames with a known appearance, for the renderer's tests.
#pragma once

#include "render/renderer.hpp"

#include <cmath>
#include <numbers>

namespace server::render {
using namespace ciel;

struct Shape {
    std::vector<Vec3f> positions, normals;
    std::vector<float> scalars;
    std::vector<Index> indices;

    [[nodiscard]] Primitives primitives() const {
        Primitives primitives;
        primitives.positions = positions;
        primitives.normals = normals;
        primitives.scalars = scalars;
        primitives.indices = indices;
        return primitives;
    }
};

// Triangulates position(u, v), for u and v from 0 to 1, into columns x rows quadrilaterals of two triangles.
template <typename Position>
Shape grid(Index columns, Index rows, Position position) {
    Shape shape;
    for (Index j = 0; j <= rows; ++j)
        for (Index i = 0; i <= columns; ++i)
            shape.positions.push_back(position(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
    for (Index j = 0; j < rows; ++j)
        for (Index i = 0; i < columns; ++i) {
            const Index a = j * (columns + 1) + i;
            const Index b = a + 1;
            const Index c = a + columns + 1;
            const Index d = c + 1;
            for (const Index corner : {a, b, d, a, d, c}) shape.indices.push_back(corner);
        }
    return shape;
}

inline Shape sphere(double radius, Vec3d center = {}, Index columns = 96) {
    Shape shape = grid(columns, columns / 2, [&](double u, double v) {
        const double longitude = 2 * std::numbers::pi * u;
        const double latitude = std::numbers::pi * (v - 0.5);
        return Vec3f{static_cast<float>(center[0] + radius * std::cos(latitude) * std::cos(longitude)),
                     static_cast<float>(center[1] + radius * std::cos(latitude) * std::sin(longitude)),
                     static_cast<float>(center[2] + radius * std::sin(latitude))};
    });
    for (const Vec3f& p : shape.positions) {
        shape.normals.push_back({static_cast<float>((p[0] - center[0]) / radius),
                                 static_cast<float>((p[1] - center[1]) / radius),
                                 static_cast<float>((p[2] - center[2]) / radius)});
    }
    return shape;
}

// Square in the plane y = `depth`, from -1 to 1 in x and z. Its scalar is x.
inline Shape square(double depth) {
    Shape shape = grid(32, 32, [&](double u, double v) {
        return Vec3f{static_cast<float>(2 * u - 1), static_cast<float>(depth), static_cast<float>(2 * v - 1)};
    });
    for (const Vec3f& p : shape.positions) shape.scalars.push_back(p[0]);
    return shape;
}

// Line segment between two points. Borrows `ends`, which must outlive the result; `width` in pixels.
inline Primitives line_between(const std::vector<Vec3f>& ends, float width, std::array<float, 4> color = {1, 1, 1, 1}) {
    static const std::vector<Index> both{0, 1};
    Primitives line;
    line.positions = ends;
    line.indices = both;
    line.lines = true;
    line.line_width = width;
    line.color = color;
    return line;
}

// Frame with a parallel camera that looks along +y: x to the right, z up, and 3 units high.
inline Frame front_view(int width = 320, int height = 240) {
    Frame frame;
    frame.width = width;
    frame.height = height;
    frame.camera.position = {0, -5, 0};
    frame.camera.up = {0, 0, 1};
    frame.camera.parallel = true;
    frame.camera.parallel_height = 3;
    frame.bounds_min = {-1, -1, -1};
    frame.bounds_max = {1, 1, 1};
    frame.background_top = {0.10F, 0.12F, 0.16F};
    frame.background_bottom = {0.03F, 0.04F, 0.05F};
    return frame;
}

} // namespace server::render
