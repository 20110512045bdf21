// Interpolates an array at the points of a surface, along the mesh edge of each point.
#include "ciel/extract.hpp"
#include "ciel/parallel.hpp"

namespace ciel {

namespace {

template <class T>
void interpolate_all(std::span<const EdgePoint> points, std::span<const T> values, int components, std::span<T> out) {
    if (components < 1) fail("an array to interpolate has no components; it must have at least one");
    const auto width = static_cast<std::size_t>(components);
    if (out.size() != points.size() * width)
        fail("the output of the interpolation must have room for " + std::to_string(points.size() * width) +
             " values, not " + std::to_string(out.size()));
    parallel_for(points.size(), 16384, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t c = 0; c < width; ++c)
                out[i * width + c] =
                    lerp(values[points[i].a * width + c], values[points[i].b * width + c], points[i].t);
    });
}

} // namespace

void interpolate(std::span<const EdgePoint> points, std::span<const float> values, int components,
                 std::span<float> out) {
    interpolate_all(points, values, components, out);
}

void interpolate(std::span<const EdgePoint> points, std::span<const double> values, int components,
                 std::span<double> out) {
    interpolate_all(points, values, components, out);
}

} // namespace ciel
