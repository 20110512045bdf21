// Makes textures of the depth of opaque surfaces and the slopes of transparent surfaces. From these textures, shaders
// of lines and points find the rise of a surface under a line or point, and move the line or point nearer to the eye by
// this rise (on_surface_glsl in shader_parts.cpp).
#pragma once

#include "render/surfaces/shaders.hpp"
#include "render/target/sheet.hpp"
#include "render/target/target.hpp"

#include <functional>

namespace server::render {

// The GL objects exist until the GL context is destroyed. A change of size keeps their names.
class SurfaceSlopes {
public:
    explicit SurfaceSlopes(const Gl& gl);
    SurfaceSlopes(const SurfaceSlopes&) = delete;
    SurfaceSlopes& operator=(const SurfaceSlopes&) = delete;

    void begin(); // forgets the surfaces of the last frame
    // Copies the depth of the target, on which only opaque surfaces have been drawn. Leaves the target bound.
    void copy_opaque(Target& target, int width, int height);
    // Finds the slopes of transparent surfaces. `draw` uses program(), sets its uniforms, and draws all transparent
    // triangles. Throws Error if the GL cannot draw to this size. Binds another framebuffer and changes the viewport.
    void find_sheets(int width, int height, const std::function<void()>& draw);
    [[nodiscard]] const Program& program() const { return program_; }
    // Sets the textures of a line or point program, which must be in use.
    void use(const Program& program) const;

private:
    const Gl& gl_;
    Program program_;
    Sheet sheets_;
    // Textures of one texel: far_ is used without opaque surfaces, flat_ without transparent surfaces.
    GLuint opaque_ = 0, framebuffer_ = 0, far_ = 0, flat_ = 0;
    GLuint opaque_used_ = 0, sheets_used_ = 0;
    int width_ = 0, height_ = 0;
};

} // namespace server::render
