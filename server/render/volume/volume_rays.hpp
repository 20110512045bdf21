// Where the ray of each pixel is inside a volume's mesh, between the clip planes, and in front of what is opaque.
#pragma once

#include "annotations/camera.hpp"
#include "render/target/sheet.hpp"
#include "render/target/touched_tiles.hpp"
#include "render/volume/volume_buffers.hpp"
#include "render/volume/volume_shaders.hpp"

#include <list>
#include <map>

namespace ciel::render {

// What decides where rays run: what was found for some is good for the same again.
struct RayPlaces {
    glm::dmat4 view{1}, projection{1};
    int width = 0, height = 0;
    bool parallel = false, eye_is_in_bounds = false;
    bool operator==(const RayPlaces&) const = default;
};

// Of the picture being drawn.
struct VolumeView {
    const Frame* frame = nullptr;
    const annotations::ViewTransform* transform = nullptr;
    GLuint opaque = 0;         // window depths that rays end on, or 0
    int width = 0, height = 0; // in rays
    // All volumes' meshes are in this box: offsets from the frame's origin.
    Vec3d low{}, high{};

    // Of a pixel at (x, y): sideways per depth corner + step * (x, y), from there at depth 0 on.
    struct Rays {
        glm::dvec2 corner, step, side_corner, side_step;
    };
    [[nodiscard]] Rays rays_of_pixels() const;
    void set_rays(const ShaderProgram& program) const; // of the program in use
    [[nodiscard]] glm::vec2 parallel_depths() const;   // nearest and span; zero for a perspective
    [[nodiscard]] double eye_along(const Vec3d& normal) const;
    [[nodiscard]] bool is_clipped() const { return !frame->clip.empty(); }
    [[nodiscard]] bool eye_is_in_bounds() const;
    [[nodiscard]] RayPlaces places() const;
    // The box as it is seen, in a picture of width x height: no ray elsewhere meets a volume.
    [[nodiscard]] PixelBox seen_box(int width, int height) const;
};

// What is found for one boundary, good until the next begin().
struct RaySheets {
    explicit RaySheets(const Gl& gl) : limits(gl) {
        for (int i = 0; i < most_ray_parts; ++i) parts.emplace_back(gl);
    }
    std::vector<Sheet> parts; // as make_part_program() says, so many as `count`
    Sheet limits;             // as make_limits_program() says
    int count = 0;
    std::uint64_t boundary = 0;
    RayPlaces places; // that the parts are of
};

// Its GL objects live as long as their context.
class VolumeRays {
public:
    explicit VolumeRays(const Gl& gl);
    VolumeRays(const VolumeRays&) = delete;
    VolumeRays& operator=(const VolumeRays&) = delete;

    void begin(const VolumeView& view);
    // Once for all volumes with the same boundary.
    const RaySheets& find(const VolumeBuffers& buffers);
    // Of a slab's program in use.
    static void set_units(const ShaderProgram& program);
    void bind(const RaySheets& rays) const; // to these units, which are 0 and from 3 on
    // What they all have is found: where the nearest of them begins.
    void finish();
    [[nodiscard]] GLuint begin_of_all() const {
        return begins_;
    } // RGBA32F as limits, only A is good; 0 before finish()

private:
    void find_kept();
    void find_parts(const VolumeBuffers& buffers, RaySheets& rays);
    bool find_next_part(const VolumeBuffers& buffers, RaySheets& rays, int part);
    void find_limits(RaySheets& rays);
    void cover_box() const;

    const Gl& gl_;
    ShaderProgram first_part_, next_part_, kept_program_, copy_program_;
    std::map<int, ShaderProgram> limits_programs_; // by the number of parts
    Sheet kept_, nearest_;
    std::list<RaySheets> sheets_;
    std::size_t in_use_ = 0; // of them
    VolumeView view_;
    GLuint query_ = 0, no_array_ = 0, begins_ = 0;
};

} // namespace ciel::render
