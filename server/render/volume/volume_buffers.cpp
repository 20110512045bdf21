#include "render/volume/volume_buffers.hpp"

#include "render/context/pacing.hpp"
#include "render/volume/boundary_of_slabs.hpp"
#include "render/volume/slab_shaders.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace server::render {
namespace {

template <class T>
GLsizeiptr bytes(const std::vector<T>& items) {
    return static_cast<GLsizeiptr>(items.size() * sizeof(T));
}

void check(const color::SlabTriangles& mesh) {
    const auto largest = std::ranges::max_element(mesh.triangles);
    if (mesh.triangles.size() % 3 != 0 || (largest != mesh.triangles.end() && *largest >= mesh.vertices.size()))
        throw ciel::Error(
            "a slice or the boundary of a volume has wrong triangles; each triangle must have three vertex "
            "indices that are less than " +
            std::to_string(mesh.vertices.size()) + ", the number of vertices");
}

VolumeBuffers::Bounds bounds_of(const color::SlabTriangles& mesh) {
    VolumeBuffers::Bounds bounds{mesh.vertices.empty() ? ciel::Vec3f{} : mesh.vertices[0].position, {}};
    bounds.high = bounds.low;
    for (const color::SlabVertex& vertex : mesh.vertices)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            bounds.low[axis] = std::min(bounds.low[axis], vertex.position[axis]);
            bounds.high[axis] = std::max(bounds.high[axis], vertex.position[axis]);
        }
    return bounds;
}

std::uint64_t places_of(const color::SlabTriangles& mesh) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    const auto add = [&](std::uint32_t word) { hash = (hash ^ word) * 0x100000001b3U; };
    for (const color::SlabVertex& vertex : mesh.vertices)
        for (const float coordinate : vertex.position) add(std::bit_cast<std::uint32_t>(coordinate));
    for (const ciel::Index corner : mesh.triangles) add(corner);
    return hash;
}

VertexArrays make_arrays(const Gl& gl) {
    return make_vertex_arrays(gl, sizeof(color::SlabVertex),
                              {{volume_position, 3, offsetof(color::SlabVertex, position)},
                               {volume_value, 1, offsetof(color::SlabVertex, value)},
                               {volume_gradient, 3, offsetof(color::SlabVertex, gradient)},
                               {volume_limits, 2, offsetof(color::SlabVertex, limits)}});
}

} // namespace

VolumeBuffers::VolumeBuffers(const Gl& gl) : gl_(gl), slices_(make_arrays(gl)), boundary_(make_arrays(gl)) {}

void VolumeBuffers::load(const Volume& volume) {
    const bool same_slices = identity_ == volume.identity && revision_ == volume.revision && revision_ != 0;
    if (same_slices && stride_ == volume.stride) return;
    if (volume.boundary == nullptr || volume.stride == 0 || !(volume.thickness > 0) || volume.slices.empty())
        throw ciel::Error(
            "a volume to draw lacks slices, a boundary, a stride above 0, or a distance above 0 between its "
            "slices; give all of them");
    revision_ = 0; // not valid if anything below throws
    if (!same_slices)
        for (const color::SlabTriangles& slice : volume.slices) check(slice);
    check(*volume.boundary);
    const auto boundary = render::boundary_of_slabs(volume);
    upload_slices(sort_slices(volume, boundary));
    upload_boundary(*volume.boundary, boundary);
    identity_ = volume.identity;
    revision_ = volume.revision;
    stride_ = volume.stride;
}

void VolumeBuffers::upload_slices(const std::vector<SortedSlice>& slices) {
    GLsizeiptr vertex_bytes = 0, index_bytes = 0;
    for (const SortedSlice& sorted : slices) {
        if (sorted.slice != nullptr) vertex_bytes += bytes(sorted.slice->vertices) + bytes(sorted.more);
        index_bytes += bytes(sorted.triangles);
    }
    gl_.BindVertexArray(slices_.array);
    gl_.BindBuffer(GL_ARRAY_BUFFER, slices_.vertices);
    gl_.BufferData(GL_ARRAY_BUFFER, vertex_bytes, nullptr, GL_STATIC_DRAW);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, index_bytes, nullptr, GL_STATIC_DRAW);
    slice_of_slab_.clear();
    slice_ranges_.clear();
    std::size_t vertices = 0, indices = 0;
    const auto append = [&](const std::vector<color::SlabVertex>& more) {
        gl_.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(vertices * sizeof(color::SlabVertex)), bytes(more),
                          more.data());
        vertices += more.size();
    };
    for (const SortedSlice& sorted : slices) {
        const auto base = static_cast<GLint>(vertices);
        if (sorted.slice != nullptr) append(sorted.slice->vertices);
        append(sorted.more);
        gl_.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(indices * sizeof(ciel::Index)),
                          bytes(sorted.triangles), sorted.triangles.data());
        const auto all = static_cast<GLsizei>(sorted.triangles.size()), outer = static_cast<GLsizei>(sorted.outer);
        slice_of_slab_.push_back({{indices, outer, base}, {indices + sorted.outer, all - outer, base}});
        slice_ranges_.push_back(
            boxed_ranges_of({indices, all, base}, sorted.triangles, [&](ciel::Index i) -> const ciel::Vec3f& {
                const std::size_t own = sorted.slice->vertices.size();
                return i < own ? sorted.slice->vertices[i].position : sorted.more[i - own].position;
            }));
        indices += sorted.triangles.size();
    }
}

void VolumeBuffers::upload_boundary(const color::SlabTriangles& mesh,
                                    const std::vector<std::vector<ciel::Index>>& lists) {
    std::vector<ciel::Index> indices = mesh.triangles;
    boundary_places_ = places_of(mesh);
    bounds_ = bounds_of(mesh);
    whole_boundary_ = {0, static_cast<GLsizei>(indices.size()), 0};
    boundary_of_slab_.clear();
    boundary_ranges_.clear();
    for (const std::vector<ciel::Index>& list : lists) {
        boundary_of_slab_.push_back({indices.size(), static_cast<GLsizei>(list.size()), 0});
        boundary_ranges_.push_back(
            boxed_ranges_of(boundary_of_slab_.back(), list,
                            [&](ciel::Index i) -> const ciel::Vec3f& { return mesh.vertices[i].position; }));
        indices.insert(indices.end(), list.begin(), list.end());
    }
    gl_.BindVertexArray(boundary_.array);
    gl_.BindBuffer(GL_ARRAY_BUFFER, boundary_.vertices);
    gl_.BufferData(GL_ARRAY_BUFFER, bytes(mesh.vertices), mesh.vertices.data(), GL_STATIC_DRAW);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, bytes(indices), indices.data(), GL_STATIC_DRAW);
}

void VolumeBuffers::draw(const IndexRange& range) const {
    draw_elements(gl_, GL_TRIANGLES, range.first, static_cast<std::size_t>(range.count), range.base);
}

} // namespace server::render
