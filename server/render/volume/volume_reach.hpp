// Depth buffer for a picture of the volumes in front of a transparent layer. It rejects slab fragments beside and
// behind the layer before their programs run. Of many layers the later ones are small.
#pragma once

#include "render/volume/volume_rays.hpp"

#include <vector>

namespace ciel::render {

// Window depths, and colors that are empty outside the layer: textures of one size, any multiple of the rays'.
struct LayerInVolumes {
    GLuint depth = 0, color = 0; // 0: no layer
};

// Its GL objects live as long as their context.
class VolumeReach {
public:
    explicit VolumeReach(const Gl& gl);
    VolumeReach(const VolumeReach&) = delete;
    VolumeReach& operator=(const VolumeReach&) = delete;

    // Binds the picture, which has the view's size, with the depth buffer. `slabs`: number of slabs along a ray per
    // depth, (at the picture's corner, per pixel x, y). Leaves the depth test on.
    // Throws Error when the GL cannot draw to this size.
    void begin(const VolumeView& view, const LayerInVolumes& layer, const Sheet& picture, const glm::dvec3& slabs);

    // Returns whether a part of the box may be in front of the layer.
    [[nodiscard]] bool meets(const Vec3f& low, const Vec3f& high) const;

private:
    void read_tiles();
    void size(const VolumeView& view, GLuint picture);
    void find_pixels(const VolumeView& view, const LayerInVolumes& layer);

    const Gl& gl_;
    ShaderProgram pixels_program_, reach_program_, tiles_program_;
    Sheet pixels_, tiles_;        // 1 where the layer is; the farthest depth of a tile of pixels
    std::vector<float> farthest_; // of the tiles, row by row from below
    int columns_ = 0, rows_ = 0;
    glm::dmat4 to_clip_{1};
    GLuint framebuffer_ = 0, depth_ = 0, no_array_ = 0;
    int width_ = 0, height_ = 0;
};

} // namespace ciel::render
