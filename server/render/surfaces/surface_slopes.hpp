// What lines and points must know of the surfaces that they lie on, to come before them by what these rise under their
// width (shaders.cpp): the depth of what is opaque, and how steep the transparent ones are.
#pragma once

#include "render/surfaces/shaders.hpp"
#include "render/target/sheet.hpp"
#include "render/target/target.hpp"

#include <functional>

namespace ciel::render {

// Its GL objects live as long as their context; a change of size allocates anew behind the same names.
class SurfaceSlopes {
public:
    explicit SurfaceSlopes(const Gl& gl);
    SurfaceSlopes(const SurfaceSlopes&) = delete;
    SurfaceSlopes& operator=(const SurfaceSlopes&) = delete;

    void begin(); // nothing is there
    // The depth of the target, on which only opaque surfaces have been drawn. Throws Error when the size is more than
    // the GL can do.
    void copy_opaque(Target& target, int width, int height);
    // `draw` draws all transparent triangles, with the program in use whose uniforms the caller sets.
    void find_sheets(int width, int height, const std::function<void()>& draw);
    [[nodiscard]] const Program& program() const { return program_; }
    // For a program of lines or points, which is in use.
    void use(const Program& program) const;

private:
    const Gl& gl_;
    Program program_;
    Sheet sheets_;
    GLuint opaque_ = 0, framebuffer_ = 0, far_ = 0, flat_ = 0; // the last two: of nothing
    GLuint opaque_used_ = 0, sheets_used_ = 0;
    int width_ = 0, height_ = 0;
};

} // namespace ciel::render
