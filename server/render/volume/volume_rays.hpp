// Finds where rays are inside a volume's mesh, between the clip planes, and in front of opaque surfaces.
#pragma once

#include "annotations/camera.hpp"
#include "render/target/sheet.hpp"
#include "render/target/touched_tiles.hpp"
#include "render/volume/volume_buffers.hpp"
#include "render/volume/volume_shaders.hpp"

#include <list>
#include <map>

namespace server::render {

// Inputs of the ray parts. If these inputs are equal, the ray parts are reused. A ray part is an interval of a ray
// inside a mesh.
struct RayPlaces {
    glm::dmat4 view{1}, projection{1};
    int width = 0, height = 0;
    bool parallel = false, eye_is_in_bounds = false;
    bool operator==(const RayPlaces&) const = default;
};

// View of the picture being drawn. Does not own frame and transform, which must outlive the VolumeView.
struct VolumeView {
    const Frame* frame = nullptr;
    const annotations::ViewTransform* transform = nullptr;
    GLuint opaque = 0;         // texture of the window depths at which rays end, or 0
    int width = 0, height = 0; // size of the volumes' picture in pixels, one ray per pixel
    // Bounding box of the meshes of all volumes, as offsets from the frame's origin.
    ciel::Vec3d low{}, high{};

    // The ray of pixel p in eye space. Its x and y at a given depth are
    // side_corner + side_step * p + depth * (corner + step * p).
    struct Rays {
        glm::dvec2 corner, step, side_corner, side_step;
    };
    [[nodiscard]] Rays rays_of_pixels() const;
    void set_rays(const ShaderProgram& program) const; // `program` must be in use
    // Returns (nearest depth, farthest depth - nearest depth); (0, 0) for a perspective view.
    [[nodiscard]] glm::vec2 parallel_depths() const;
    [[nodiscard]] double eye_along(const ciel::Vec3d& normal) const;
    [[nodiscard]] bool is_clipped() const { return !frame->clip.empty(); }
    [[nodiscard]] bool eye_is_in_bounds() const;
    [[nodiscard]] RayPlaces places() const;
    // Returns the pixels that the volumes may cover in a picture of width x height pixels.
    [[nodiscard]] PixelBox seen_box(int width, int height) const;
};

// Ray parts and limits for one boundary. They are valid until the next VolumeRays::begin().
struct RaySheets {
    explicit RaySheets(const Gl& gl) : limits(gl) {
        for (int i = 0; i < most_ray_parts; ++i) parts.emplace_back(gl);
    }
    std::vector<Sheet> parts; // output of make_part_program(); the first `count` are valid
    Sheet limits;             // output of make_limits_program()
    int count = 0;
    std::uint64_t boundary = 0;
    RayPlaces places; // inputs of the parts
};

// The GL objects exist until the GL context is destroyed.
class VolumeRays {
public:
    explicit VolumeRays(const Gl& gl);
    VolumeRays(const VolumeRays&) = delete;
    VolumeRays& operator=(const VolumeRays&) = delete;

    void begin(const VolumeView& view);
    // Returns the textures for the boundary, valid until the next begin(). Volumes with the same boundary share them.
    const RaySheets& find(const VolumeBuffers& buffers);
    // Sets the sampler uniforms of a slab program, which must be in use.
    static void set_units(const ShaderProgram& program);
    // Binds the textures to the units that set_units() sets: 0, and from 3 on.
    void bind(const RaySheets& rays) const;
    // Call after the last find(). Computes begin_of_all() from the limits of all boundaries.
    void finish();
    // Returns an RGBA32F texture. Only A is valid: window depth at which the volumes begin. Returns 0 before finish().
    [[nodiscard]] GLuint begin_of_all() const { return begins_; }

private:
    void find_kept();
    void find_parts(const VolumeBuffers& buffers, RaySheets& rays);
    bool find_next_part(const VolumeBuffers& buffers, RaySheets& rays, int part);
    void find_limits(RaySheets& rays);
    void cover_box() const;

    const Gl& gl_;
    ShaderProgram first_part_, next_part_, kept_program_, copy_program_;
    std::map<int, ShaderProgram> limits_programs_; // key: number of ray parts
    Sheet kept_, nearest_;
    std::list<RaySheets> sheets_;
    std::size_t in_use_ = 0; // the first in_use_ elements of sheets_ belong to the current frame
    VolumeView view_;
    GLuint query_ = 0, no_array_ = 0, begins_ = 0;
};

} // namespace server::render
