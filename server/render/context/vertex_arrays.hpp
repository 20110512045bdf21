// A vertex array whose vertices are structs of floats in one buffer.
#pragma once

#include "render/context/gl.hpp"

#include <cstddef>
#include <initializer_list>

namespace server::render {

struct VertexArrays { // names of GL objects, which exist until the GL context is destroyed
    GLuint array = 0, vertices = 0, indices = 0;
};

struct VertexMember {
    GLuint attribute = 0;
    int components = 1;
    std::size_t offset = 0; // offset of the member in the vertex struct, in bytes
};

[[nodiscard]] VertexArrays make_vertex_arrays(const Gl& gl, std::size_t bytes_of_vertex,
                                              std::initializer_list<VertexMember> members);

} // namespace server::render
