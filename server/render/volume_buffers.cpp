#include "render/volume_buffers.hpp"

#include "render/volume_shaders.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace ciel::render {
namespace {

template <class T>
GLsizeiptr bytes(const std::vector<T>& items) {
    return static_cast<GLsizeiptr>(items.size() * sizeof(T));
}

const void* offset(std::size_t bytes_in_buffer) {
    return reinterpret_cast<const void*>(bytes_in_buffer); // NOLINT(performance-no-int-to-ptr): GL's own way
}

void check(const SlabMesh& mesh) {
    const auto largest = std::ranges::max_element(mesh.triangles);
    if (mesh.triangles.size() % 3 != 0 || (largest != mesh.triangles.end() && *largest >= mesh.vertices.size()))
        throw Error("a volume to draw has a slice whose triangles do not fit its " +
                    std::to_string(mesh.vertices.size()) + " vertices");
}

// The triangles that each slab has a part of. One on the border of two is in both lists: the program that draws them
// decides pixel by pixel.
std::vector<std::vector<Index>> triangles_of_slabs(const Volume& volume, double thickness, std::size_t slabs) {
    std::vector<std::vector<Index>> lists(slabs);
    const SlabMesh& mesh = *volume.boundary;
    const auto place = [&](Index vertex) {
        const Vec3f& p = mesh.vertices[vertex].position;
        return (volume.normal[0] * p[0] + volume.normal[1] * p[1] + volume.normal[2] * p[2] - volume.first) / thickness;
    };
    const double last = static_cast<double>(slabs) - 1;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const Index* triangle = &mesh.triangles[i];
        const auto [low, high] = std::minmax({place(triangle[0]), place(triangle[1]), place(triangle[2])});
        constexpr double rounding = 1e-3;
        const auto begin = static_cast<std::size_t>(std::clamp(std::floor(low - rounding), 0.0, last));
        const auto end = static_cast<std::size_t>(std::clamp(std::floor(high + rounding), 0.0, last));
        for (std::size_t slab = begin; slab <= end; ++slab)
            lists[slab].insert(lists[slab].end(), triangle, triangle + 3);
    }
    return lists;
}

// FNV-1a, by words.
std::uint64_t places_of(const SlabMesh& mesh) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    const auto add = [&](std::uint32_t word) { hash = (hash ^ word) * 0x100000001b3U; };
    for (const SlabVertex& vertex : mesh.vertices)
        for (const float coordinate : vertex.position) add(std::bit_cast<std::uint32_t>(coordinate));
    for (const Index corner : mesh.triangles) add(corner);
    return hash;
}

} // namespace

VolumeBuffers::VolumeBuffers(const Gl& gl) : gl_(gl), slices_(make_arrays()), boundary_(make_arrays()) {}

VolumeBuffers::Arrays VolumeBuffers::make_arrays() const {
    Arrays arrays;
    gl_.GenVertexArrays(1, &arrays.array);
    gl_.GenBuffers(1, &arrays.vertices);
    gl_.GenBuffers(1, &arrays.indices);
    gl_.BindVertexArray(arrays.array);
    gl_.BindBuffer(GL_ARRAY_BUFFER, arrays.vertices);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, arrays.indices);
    const auto attribute = [&](GLuint index, int components, std::size_t at) {
        gl_.EnableVertexAttribArray(index);
        gl_.VertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, sizeof(SlabVertex), offset(at));
    };
    attribute(volume_position, 3, offsetof(SlabVertex, position));
    attribute(volume_value, 1, offsetof(SlabVertex, value));
    attribute(volume_gradient, 3, offsetof(SlabVertex, gradient));
    attribute(volume_limits, 2, offsetof(SlabVertex, limits));
    return arrays;
}

void VolumeBuffers::load(const Volume& volume) {
    if (identity_ == volume.identity && revision_ == volume.revision && stride_ == volume.stride && revision_ != 0)
        return;
    if (volume.boundary == nullptr || volume.stride == 0 || !(volume.thickness > 0) || volume.slices.empty())
        throw Error("a volume to draw lacks slices, a boundary, or a thickness of its slabs");
    const bool same_slices = identity_ == volume.identity && revision_ == volume.revision && revision_ != 0;
    revision_ = 0; // until all has gone well
    if (!same_slices) upload_slices(volume);
    upload_boundary(volume);
    const std::size_t slabs = boundary_of_slab_.size();
    slice_of_slab_.assign(slabs, {});
    for (std::size_t slab = 0; slab < slabs; ++slab)
        if (const std::size_t slice = slab * volume.stride + volume.stride / 2; slice < all_slices_.size())
            slice_of_slab_[slab] = all_slices_[slice];
    identity_ = volume.identity;
    revision_ = volume.revision;
    stride_ = volume.stride;
}

void VolumeBuffers::upload_slices(const Volume& volume) {
    GLsizeiptr vertex_bytes = 0, index_bytes = 0;
    for (const SlabMesh& slice : volume.slices) {
        check(slice);
        vertex_bytes += bytes(slice.vertices);
        index_bytes += bytes(slice.triangles);
    }
    gl_.BindVertexArray(slices_.array);
    gl_.BindBuffer(GL_ARRAY_BUFFER, slices_.vertices);
    gl_.BufferData(GL_ARRAY_BUFFER, vertex_bytes, nullptr, GL_STATIC_DRAW);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, index_bytes, nullptr, GL_STATIC_DRAW);
    all_slices_.clear();
    std::size_t vertices = 0, indices = 0;
    for (const SlabMesh& slice : volume.slices) {
        gl_.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(vertices * sizeof(SlabVertex)), bytes(slice.vertices),
                          slice.vertices.data());
        gl_.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(indices * sizeof(Index)),
                          bytes(slice.triangles), slice.triangles.data());
        all_slices_.push_back({indices, static_cast<GLsizei>(slice.triangles.size()), static_cast<GLint>(vertices)});
        vertices += slice.vertices.size();
        indices += slice.triangles.size();
    }
}

void VolumeBuffers::upload_boundary(const Volume& volume) {
    const SlabMesh& mesh = *volume.boundary;
    check(mesh);
    const std::size_t slabs = (volume.slices.size() + volume.stride - 1) / volume.stride;
    const auto lists = triangles_of_slabs(volume, volume.thickness * static_cast<double>(volume.stride), slabs);
    std::vector<Index> indices = mesh.triangles;
    boundary_places_ = places_of(mesh);
    whole_boundary_ = {0, static_cast<GLsizei>(indices.size()), 0};
    boundary_of_slab_.clear();
    for (const std::vector<Index>& list : lists) {
        boundary_of_slab_.push_back({indices.size(), static_cast<GLsizei>(list.size()), 0});
        indices.insert(indices.end(), list.begin(), list.end());
    }
    gl_.BindVertexArray(boundary_.array);
    gl_.BindBuffer(GL_ARRAY_BUFFER, boundary_.vertices);
    gl_.BufferData(GL_ARRAY_BUFFER, bytes(mesh.vertices), mesh.vertices.data(), GL_STATIC_DRAW);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, bytes(indices), indices.data(), GL_STATIC_DRAW);
}

void VolumeBuffers::draw(const IndexRange& range) const {
    if (range.count == 0) return;
    gl_.DrawElementsBaseVertex(GL_TRIANGLES, range.count, GL_UNSIGNED_INT, offset(range.first * sizeof(Index)),
                               range.base);
}

} // namespace ciel::render
