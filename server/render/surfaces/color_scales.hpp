// The color scales of one frame as textures, which color_glsl.hpp reads.
#pragma once

#include "color/color_scale.hpp"
#include "render/context/gl.hpp"
#include "render/frame/frame.hpp"

#include <vector>

namespace ciel::render {

// The color scale of a mesh. `origin` is subtracted from values before they are interpolated to the pixels.
// Otherwise a small range at a large offset, such as 101,325 and a little, would lose its digits.
struct ScaleRow {
    float row = -1; // in the frame's ColorScales; -1: a solid mesh
    float origin = 0;
    bool operator==(const ScaleRow&) const = default;
};

struct ScaledPrimitives {
    const Primitives* primitives;
    ScaleRow scale;
};

class ColorScales {
public:
    explicit ColorScales(const Gl& gl); // the context is current, here and in every other call
    ColorScales(const ColorScales&) = delete;
    ColorScales& operator=(const ColorScales&) = delete;

    void begin() { next_.clear(); }
    // Returns the row of the scale; equal scales share one. Throws Error for an unknown color map.
    [[nodiscard]] ScaleRow row_of(const color::ColorScale& scale);
    // Call after the last row_of(). Uploads the rows unless they equal the last upload.
    void upload();
    // To texture units 0 and 1, for the samplers scale_colors and scale_rules.
    void bind() const;

private:
    const Gl& gl_;
    GLuint colors_ = 0, rules_ = 0;
    std::vector<color::ColorScale> next_, uploaded_;
};

} // namespace ciel::render
