// The color scales of one frame as textures: what color_glsl.hpp looks up.
#pragma once

#include "color/color_scale.hpp"
#include "render/context/gl.hpp"
#include "render/frame/frame.hpp"

#include <vector>

namespace ciel::render {

// What a mesh's values are looked up by. They are carried to the pixels less `origin`, or those of a small range beside
// them, such as 101,325 and a little, would lose their digits on the way.
struct ScaleRow {
    float row = -1; // of the frame's ColorScales; -1: a solid mesh
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
    // Equal scales share one. Throws Error when there is no such color map.
    [[nodiscard]] ScaleRow row_of(const color::ColorScale& scale);
    // After the last row_of: uploads the rows unless they are there from the frame before.
    void upload();
    // To texture units 0 and 1, for the samplers scale_colors and scale_rules.
    void bind() const;

private:
    const Gl& gl_;
    GLuint colors_ = 0, rules_ = 0;
    std::vector<color::ColorScale> next_, uploaded_;
};

} // namespace ciel::render
