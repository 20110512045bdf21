// The color scales of one frame as textures, which color_scale_glsl reads (shared_glsl.hpp).
#pragma once

#include "color/color_scale.hpp"
#include "render/context/gl.hpp"
#include "render/frame/frame.hpp"

#include <vector>

namespace ciel::render {

// Color scale of a mesh. `origin` is subtracted from values before they are interpolated to the pixels. Otherwise
// floats would have too few digits for a small range at a large offset, such as 101,325 to 101,326.
struct ScaleRow {
    float row = -1; // row in the textures of ColorScales; -1: the mesh has a solid color
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
    // Returns the row of the scale; equal scales share one. Throws Error for an unknown color map.
    [[nodiscard]] ScaleRow row_of(const color::ColorScale& scale);
    // Call after the last row_of(). Uploads the rows unless they equal the last upload.
    void upload();
    // Binds the textures of the samplers scale_colors and scale_rules to texture units 0 and 1.
    void bind() const;

private:
    const Gl& gl_;
    GLuint colors_ = 0, rules_ = 0;
    std::vector<color::ColorScale> next_, uploaded_;
};

} // namespace ciel::render
