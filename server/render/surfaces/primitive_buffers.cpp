#include "render/surfaces/primitive_buffers.hpp"

#include "render/context/pacing.hpp"
#include "render/frame/frame_properties.hpp"
#include "render/surfaces/shaders.hpp"

#include <algorithm>

namespace server::render {

void check_primitives(const Primitives& mesh) {
    const std::size_t vertices = mesh.positions.size();
    ciel::Index largest = 0;
    for (const ciel::Index vertex : mesh.indices) largest = std::max(largest, vertex);
    if ((!mesh.normals.empty() && mesh.normals.size() != vertices) ||
        (!mesh.scalars.empty() && mesh.scalars.size() != vertices) || mesh.indices.size() % corners_of(mesh) != 0 ||
        (!mesh.indices.empty() && largest >= vertices)) {
        throw ciel::Error(
            "the arrays of a mesh to draw do not match; normals and scalars must be empty or one for each vertex, "
            "indices must be less than the number of vertices, and each primitive must be complete: there are " +
            std::to_string(vertices) + " vertices, " + std::to_string(mesh.normals.size()) + " normals, " +
            std::to_string(mesh.scalars.size()) + " scalars and " + std::to_string(mesh.indices.size()) +
            " indices, of which the largest is " + std::to_string(largest));
    }
}

PrimitiveBuffers::PrimitiveBuffers(const Gl& gl) : gl_(gl) {
    gl_.GenVertexArrays(1, &array_);
    for (GLuint* buffer : {&positions_, &normals_, &scalars_, &indices_}) gl_.GenBuffers(1, buffer);
}

void PrimitiveBuffers::upload(GLuint buffer, GLenum target, std::size_t bytes, const void* data) {
    gl_.BindBuffer(target, buffer);
    fill_buffer(gl_, target, bytes, data);
}

void PrimitiveBuffers::attribute(GLuint index, GLuint buffer, int components, std::size_t bytes, const void* data) {
    if (bytes == 0) {
        gl_.DisableVertexAttribArray(index);
        return;
    }
    upload(buffer, GL_ARRAY_BUFFER, bytes, data);
    gl_.EnableVertexAttribArray(index);
    gl_.VertexAttribPointer(index, components, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void PrimitiveBuffers::load(const Primitives& mesh) {
    if (mesh.revision != 0 && mesh.identity == identity_ && mesh.revision == revision_) return;
    check_primitives(mesh);
    revision_ = 0; // stays 0 until the upload is complete, because cancelling may interrupt the upload
    gl_.BindVertexArray(array_);
    attribute(attribute_position, positions_, 3, mesh.positions.size_bytes(), mesh.positions.data());
    attribute(attribute_normal, normals_, 3, mesh.normals.size_bytes(), mesh.normals.data());
    std::vector<float> relative;
    if (mesh.scalars.has_doubles()) relative = ciel::floats_from(mesh.scalar_origin, mesh.scalars);
    const std::span<const float> scalars = mesh.scalars.has_doubles() ? relative : mesh.scalars.floats();
    attribute(attribute_scalar, scalars_, 1, scalars.size_bytes(), scalars.data());
    upload(indices_, GL_ELEMENT_ARRAY_BUFFER, mesh.indices.size_bytes(), mesh.indices.data());
    identity_ = mesh.identity;
    primitive_ = mesh.points ? GL_POINTS : mesh.lines ? GL_LINES : GL_TRIANGLES;
    count_ = mesh.indices.size();
    revision_ = mesh.revision;
}

void PrimitiveBuffers::draw(const Primitives& mesh, const ScaleRow& scale) const {
    gl_.BindVertexArray(array_);
    gl_.VertexAttrib3f(attribute_normal, 0, 0, 0);
    gl_.VertexAttrib1f(attribute_scalar, 0);
    gl_.VertexAttrib1f(attribute_size, mesh.point_size);
    gl_.VertexAttrib4f(attribute_color, mesh.color[0], mesh.color[1], mesh.color[2], mesh.color[3]);
    const double loaded_from = mesh.scalars.has_doubles() ? mesh.scalar_origin : 0;
    gl_.VertexAttrib3f(attribute_style, scale.row, mesh.lit ? 1.0F : 0.0F,
                       static_cast<float>(scale.origin - loaded_from));
    draw_elements(gl_, primitive_, 0, count_);
}

} // namespace server::render
