// Depth buffer for a picture of the volumes in front of a transparent layer. It rejects slab fragments beside and
// behind the layer before their fragment shaders run. If there are many layers, most layers are small, so most
// fragments are rejected.
#pragma once

#include "render/volume/volume_rays.hpp"

#include <vector>

namespace ciel::render {

// Textures of a transparent layer: window depths, and colors, which have alpha 0 outside the layer. Both textures have
// the same size, which may be any multiple of the size of the volumes' picture.
struct LayerInVolumes {
    GLuint depth = 0, color = 0; // 0: no layer
};

// The destructor does not delete the GL objects. They exist until the GL context is destroyed.
class VolumeReach {
public:
    explicit VolumeReach(const Gl& gl);
    VolumeReach(const VolumeReach&) = delete;
    VolumeReach& operator=(const VolumeReach&) = delete;

    // Binds a framebuffer with `picture` as color buffer, and with the depth buffer. `picture` has the size of the
    // view. `slabs`: number of slabs that a ray crosses per unit of depth, as (value at the picture's corner, change
    // per pixel in x, change per pixel in y). Leaves the depth test on. Throws Error if the GL cannot draw to this
    // size.
    void begin(const VolumeView& view, const LayerInVolumes& layer, const Sheet& picture, const glm::dvec3& slabs);

    // Returns whether a part of the box may be in front of the layer.
    [[nodiscard]] bool meets(const Vec3f& low, const Vec3f& high) const;

private:
    void read_tiles();
    void size(const VolumeView& view, GLuint picture);
    void find_pixels(const VolumeView& view, const LayerInVolumes& layer);

    const Gl& gl_;
    ShaderProgram pixels_program_, reach_program_, tiles_program_;
    Sheet pixels_, tiles_;        // pixels_: 1 where a ray meets the layer; tiles_: farthest depth of each tile
    std::vector<float> farthest_; // depths of tiles_, row by row from the bottom
    int columns_ = 0, rows_ = 0;
    glm::dmat4 to_clip_{1};
    GLuint framebuffer_ = 0, depth_ = 0, no_array_ = 0;
    int width_ = 0, height_ = 0;
};

} // namespace ciel::render
