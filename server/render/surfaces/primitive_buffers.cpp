#include "render/surfaces/primitive_buffers.hpp"

#include "render/context/pacing.hpp"
#include "render/frame/frame_properties.hpp"
#include "render/surfaces/shaders.hpp"

#include <algorithm>

namespace server::render {

void check_primitives(const Primitives& primitives) {
    const std::size_t vertices = primitives.positions.size();
    ciel::Index largest = 0;
    for (const ciel::Index vertex : primitives.indices) largest = std::max(largest, vertex);
    if ((!primitives.normals.empty() && primitives.normals.size() != vertices) ||
        (!primitives.scalars.empty() && primitives.scalars.size() != vertices) ||
        primitives.indices.size() % corners_of(primitives) != 0 ||
        (!primitives.indices.empty() && largest >= vertices)) {
        throw ciel::Error(
            "the arrays of primitives to draw do not match; normals and scalars must be empty or one for each vertex, "
            "indices must be less than the number of vertices, and each primitive must be complete: there are " +
            std::to_string(vertices) + " vertices, " + std::to_string(primitives.normals.size()) + " normals, " +
            std::to_string(primitives.scalars.size()) + " scalars and " + std::to_string(primitives.indices.size()) +
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

void PrimitiveBuffers::load(const Primitives& primitives) {
    if (primitives.revision != 0 && primitives.identity == identity_ && primitives.revision == revision_) return;
    check_primitives(primitives);
    revision_ = 0; // stays 0 until the upload is complete, because cancelling may interrupt the upload
    gl_.BindVertexArray(array_);
    attribute(attribute_position, positions_, 3, primitives.positions.size_bytes(), primitives.positions.data());
    attribute(attribute_normal, normals_, 3, primitives.normals.size_bytes(), primitives.normals.data());
    std::vector<float> relative;
    if (primitives.scalars.has_doubles()) relative = ciel::floats_from(primitives.scalar_origin, primitives.scalars);
    const std::span<const float> scalars = primitives.scalars.has_doubles() ? relative : primitives.scalars.floats();
    attribute(attribute_scalar, scalars_, 1, scalars.size_bytes(), scalars.data());
    upload(indices_, GL_ELEMENT_ARRAY_BUFFER, primitives.indices.size_bytes(), primitives.indices.data());
    identity_ = primitives.identity;
    primitive_ = primitives.points ? GL_POINTS : primitives.lines ? GL_LINES : GL_TRIANGLES;
    count_ = primitives.indices.size();
    revision_ = primitives.revision;
}

void PrimitiveBuffers::draw(const Primitives& primitives, const ScaleRow& scale) const {
    gl_.BindVertexArray(array_);
    gl_.VertexAttrib3f(attribute_normal, 0, 0, 0);
    gl_.VertexAttrib1f(attribute_scalar, 0);
    gl_.VertexAttrib1f(attribute_size, primitives.point_size);
    gl_.VertexAttrib4f(attribute_color, primitives.color[0], primitives.color[1], primitives.color[2],
                       primitives.color[3]);
    const double loaded_from = primitives.scalars.has_doubles() ? primitives.scalar_origin : 0;
    gl_.VertexAttrib3f(attribute_style, scale.row, primitives.lit ? 1.0F : 0.0F,
                       static_cast<float>(scale.origin - loaded_from));
    draw_elements(gl_, primitive_, 0, count_);
}

} // namespace server::render
