#include "render/picture_memory.hpp"

#include "render/frame/frame_properties.hpp"
#include "render/surfaces/depth_peeling.hpp"

#include <algorithm>

namespace server::render {
namespace {

// Memory in bytes per pixel.
constexpr std::uint64_t color_and_depth = 8;
constexpr std::uint64_t image = 6;      // RGB image and its encoded copy
constexpr std::uint64_t layers = 36;    // depth peeling: color, two layer depths, sum, three opaque depths
constexpr std::uint64_t lines = 16;     // depth peeling: records of transparent lines for two layers
constexpr std::uint64_t occlusion = 48; // depth, normals, raw and averaged light (ambient_occlusion.hpp)
constexpr std::uint64_t volumes = 72;   // pictures of 4 floats, ray parts, reach, coverage (volume_painter.hpp)

// llvmpipe keeps the programs, and the triangles of recent pictures until it needs their memory. On a busy machine
// these are three pictures, because it begins a picture before its threads have drawn the previous one.
constexpr std::uint64_t programs = 24 << 20, most_triangles = 96 << 20, copies_of_triangles = 3;

std::uint64_t bytes_of(const Primitives& primitives) {
    return primitives.positions.size_bytes() + primitives.normals.size_bytes() + primitives.scalars.size_bytes() +
           primitives.indices.size_bytes();
}

std::uint64_t bytes_of(const Volume& volume) {
    std::uint64_t bytes = volume.boundary != nullptr ? volume.boundary->memory_bytes() : 0;
    for (const color::SlabTriangles& slice : volume.slices)
        bytes = std::max<std::uint64_t>(bytes, slice.memory_bytes());
    return bytes;
}

} // namespace

std::uint64_t picture_memory(const Frame& frame) {
    const auto pixels = static_cast<std::uint64_t>(frame.width) * static_cast<std::uint64_t>(frame.height);
    const auto samples = static_cast<std::uint64_t>(frame.samples);
    std::uint64_t of_pixel = color_and_depth + image + (samples > 1 ? samples * color_and_depth : 0);
    if (has_transparent_overlays(frame) || (is_peeled(frame) && has(frame, is_transparent))) {
        const std::uint64_t finer = has_finer_layers(frame.width, frame.height, frame.samples) ? 4 : 1;
        of_pixel += finer * (layers + (has_transparent_lines(frame) ? lines : 0)) + color_and_depth;
    }
    if (frame.occlusion.radius > 0) of_pixel += occlusion;
    if (!frame.volumes.empty()) of_pixel += volumes;
    std::uint64_t bytes = pixels * of_pixel + programs, copied = 0;
    for (const Primitives& primitives : frame.primitives) {
        copied += bytes_of(primitives);
        if (is_transparent(primitives)) bytes += 2 * bytes_of(primitives); // also copied and sorted on the CPU
    }
    bytes += copied + std::min(copies_of_triangles * copied, most_triangles);
    for (const Volume& volume : frame.volumes) bytes += bytes_of(volume);
    return bytes + bytes / 8;
}

} // namespace server::render
