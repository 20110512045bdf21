#include "render/context/vertex_arrays.hpp"

namespace server::render {

VertexArrays make_vertex_arrays(const Gl& gl, std::size_t bytes_of_vertex,
                                std::initializer_list<VertexMember> members) {
    VertexArrays arrays;
    gl.GenVertexArrays(1, &arrays.array);
    gl.GenBuffers(1, &arrays.vertices);
    gl.GenBuffers(1, &arrays.indices);
    gl.BindVertexArray(arrays.array);
    gl.BindBuffer(GL_ARRAY_BUFFER, arrays.vertices);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, arrays.indices);
    for (const auto& [attribute, components, offset] : members) {
        gl.EnableVertexAttribArray(attribute);
        gl.VertexAttribPointer(
            attribute, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(bytes_of_vertex),
            reinterpret_cast<const void*>(offset)); // NOLINT(performance-no-int-to-ptr): GL's own way
    }
    return arrays;
}

} // namespace server::render
