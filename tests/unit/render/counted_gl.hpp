// OpenGL entry points that count object creation, storage allocation, uploads and read-backs.
#pragma once

#include "render/context/gl.hpp"
#include "render/context/gl_context.hpp"

#include <utility>

namespace server::render {

struct GlCounts {
    int objects = 0;       // object names generated, plus shaders and programs created
    int storage = 0;       // calls that allocate texture or renderbuffer storage
    std::size_t bytes = 0; // bytes sent to buffers
    int texture_updates = 0;
    std::size_t pixels_read = 0;
};

namespace counted {

inline GlCounts counts;

// The entry points of the driver, which the counting functions call.
inline Gl real;

template <void (*Gl::*Entry)(GLsizei, GLuint*)>
void generate(GLsizei count, GLuint* names) {
    counts.objects += count;
    (real.*Entry)(count, names);
}
inline GLuint create_program() {
    ++counts.objects;
    return real.CreateProgram();
}
inline GLuint create_shader(GLenum kind) {
    ++counts.objects;
    return real.CreateShader(kind);
}
inline void buffer_data(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    if (data != nullptr) counts.bytes += static_cast<std::size_t>(size);
    real.BufferData(target, size, data, usage);
}
inline void buffer_sub_data(GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
    counts.bytes += static_cast<std::size_t>(size);
    real.BufferSubData(target, offset, size, data);
}
inline void tex_image(GLenum target, GLint level, GLint format, GLsizei width, GLsizei height, GLint border,
                      GLenum layout, GLenum type, const void* texels) {
    ++counts.storage;
    real.TexImage2D(target, level, format, width, height, border, layout, type, texels);
}
inline void tex_sub_image(GLenum target, GLint level, GLint x, GLint y, GLsizei width, GLsizei height, GLenum layout,
                          GLenum type, const void* texels) {
    ++counts.texture_updates;
    real.TexSubImage2D(target, level, x, y, width, height, layout, type, texels);
}
inline void read_pixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum layout, GLenum type, void* pixels) {
    counts.pixels_read += static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    real.ReadPixels(x, y, width, height, layout, type, pixels);
}
inline void renderbuffer(GLenum target, GLsizei samples, GLenum format, GLsizei width, GLsizei height) {
    ++counts.storage;
    real.RenderbufferStorageMultisample(target, samples, format, width, height);
}

} // namespace counted

// Returns the driver's entry points, with counting functions in place of some. The counts are global: use one at a
// time.
inline Gl counted_gl(const GlContext& context) {
    using namespace counted;
    real = Gl::load(context.loader());
    Gl gl = real;
    gl.GenBuffers = generate<&Gl::GenBuffers>;
    gl.GenFramebuffers = generate<&Gl::GenFramebuffers>;
    gl.GenQueries = generate<&Gl::GenQueries>;
    gl.GenRenderbuffers = generate<&Gl::GenRenderbuffers>;
    gl.GenTextures = generate<&Gl::GenTextures>;
    gl.GenVertexArrays = generate<&Gl::GenVertexArrays>;
    gl.CreateProgram = create_program;
    gl.CreateShader = create_shader;
    gl.BufferData = buffer_data;
    gl.BufferSubData = buffer_sub_data;
    gl.ReadPixels = read_pixels;
    gl.TexImage2D = tex_image;
    gl.TexSubImage2D = tex_sub_image;
    gl.RenderbufferStorageMultisample = renderbuffer;
    return gl;
}

// Returns the counts since the last call and resets them.
inline GlCounts take_counts() { return std::exchange(counted::counts, {}); }

} // namespace server::render
