// Textures with the color scales of one frame. color_scale_glsl (shared_glsl.hpp) reads them.
#pragma once

#include "color/color_scale.hpp"
#include "render/context/gl.hpp"
#include "render/frame/frame.hpp"

#include <vector>

namespace server::render {

// `origin` is subtracted from the values, because floats have too few digits for a range such as 101,325 to 101,326.
struct ScaleRow {
    float row = -1; // row in the textures of ColorScales; -1: the primitives have a solid color
    float origin = 0;
    bool operator==(const ScaleRow&) const = default;
};

struct ScaledPrimitives {
    const Primitives* primitives;
    ScaleRow scale;
};

class ColorScales {
public:
    explicit ColorScales(const Gl& gl); // the GL context must be current in all calls
    ColorScales(const ColorScales&) = delete;
    ColorScales& operator=(const ColorScales&) = delete;

    void begin() { next_.clear(); }
    // Returns the row of the scale. Equal scales have the same row. Throws Error if the color map does not exist.
    [[nodiscard]] ScaleRow row_of(const color::ColorScale& scale);
    // Call after the last row_of(). Uploads the rows unless they equal the rows of the last upload.
    void upload();
    // Binds the textures of the samplers scale_colors and scale_rules to texture units 0 and 1.
    void bind() const;

private:
    const Gl& gl_;
    GLuint colors_ = 0, rules_ = 0;
    std::vector<color::ColorScale> next_, uploaded_;
};

} // namespace server::render
