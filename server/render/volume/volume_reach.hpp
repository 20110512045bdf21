// Depth buffer for the volumes in front of a transparent layer. It rejects slab fragments beside and behind the layer
// before their shaders run. If there are many layers, most are small, so most fragments are rejected.
#pragma once

#include "render/volume/volume_rays.hpp"

#include <vector>

namespace server::render {

// Textures of a transparent layer: window depths, and colors with alpha 0 outside the layer. The size of these textures
// may be any multiple of the size of the volumes' picture.
struct LayerInVolumes {
    GLuint depth = 0, color = 0; // 0: no layer
};

// The GL objects exist until the GL context is destroyed.
class VolumeReach {
public:
    explicit VolumeReach(const Gl& gl);
    VolumeReach(const VolumeReach&) = delete;
    VolumeReach& operator=(const VolumeReach&) = delete;

    // Fills the depth buffer, and binds it with the color buffer `picture`, which must have the size of the view.
    // `slabs`: number of slabs that a ray crosses per unit of depth (at the picture's corner, change per pixel in x, in
    // y). Leaves the depth test on and writing of depth off. Throws Error if the GL cannot draw to this size.
    void begin(const VolumeView& view, const LayerInVolumes& layer, const Sheet& picture, const glm::dvec3& slabs);

    // Returns whether a part of the box may be in front of the layer.
    [[nodiscard]] bool meets(const ciel::Vec3f& low, const ciel::Vec3f& high) const;

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

} // namespace server::render
