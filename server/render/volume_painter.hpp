// Draws volumes over the picture so far: where rays are inside the mesh, then its slabs from the back to the front into
// a target of floats, then that onto the picture.
#pragma once

#include "render/camera.hpp"
#include "render/target.hpp"
#include "render/volume_buffers.hpp"
#include "render/volume_shaders.hpp"

#include <functional>
#include <list>
#include <map>

namespace ciel::render {

// Its GL objects live as long as their context.
class VolumePainter {
public:
    explicit VolumePainter(const Gl& gl);
    VolumePainter(const VolumePainter&) = delete;
    VolumePainter& operator=(const VolumePainter&) = delete;

    // The texture of window depths on which rays end from now on; 0: volumes are in front of everything.
    void end_on(GLuint depth) { surfaces_ = depth; }
    // Leaves the target bound, depth test and blending as they were: on.
    void draw(const Frame& frame, const ViewTransform& transform, Target& target);
    // All volumes in front of a depth texture, or for 0 as far as draw() shows them, premultiplied, on nothing; good
    // until the next call. Leaves another framebuffer and viewport bound, depth test and blending on.
    [[nodiscard]] GLuint picture_until(const Frame& frame, const ViewTransform& transform, GLuint depth);
    // RGBA32F; A: the window's depth where the last volume begins.
    [[nodiscard]] GLuint limits() const { return limits_.texture; }

private:
    struct Sheet { // a texture to draw to
        GLuint texture = 0, framebuffer = 0;
        int width = 0, height = 0;
    };
    [[nodiscard]] Sheet make_sheet() const;
    void size(Sheet& sheet, GLint format, int width, int height) const;
    void begin(const Sheet& sheet) const;

    // Of a pixel at (x, y): sideways per depth corner + step * (x, y), from there at depth 0 on.
    struct Rays {
        glm::dvec2 corner, step, side_corner, side_step;
    };

    void draw_each(const Frame& frame, const ViewTransform& transform, GLuint depth,
                   const std::function<void()>& bind_picture);
    void draw_volume(const Volume& volume, std::size_t slot);
    int find_parts(const VolumeBuffers& buffers);
    bool find_next_part(const VolumeBuffers& buffers, int part);
    void find_kept();
    void find_limits(int parts);
    void load_table(const Volume& volume, std::size_t slot);
    void draw_slabs(const Volume& volume, const VolumeBuffers& buffers, int parts);
    [[nodiscard]] Rays rays_of_pixels() const;
    void bind_later_parts(const ShaderProgram& program, int parts) const;
    void set_rays(const ShaderProgram& program) const;
    void set_slabs(const ShaderProgram& program, const Volume& volume, double thickness, int parts) const;
    void put_on_picture(const Volume& volume) const;
    [[nodiscard]] std::vector<std::size_t> back_to_front(const Volume& volume, std::size_t slabs) const;
    [[nodiscard]] bool is_clipped() const { return !frame_->clip.empty(); }
    [[nodiscard]] glm::vec2 parallel_depths() const; // nearest and span; zero for a perspective
    [[nodiscard]] bool eye_is_in_bounds() const;
    [[nodiscard]] double eye_place(const Volume& volume) const; // across the slabs
    [[nodiscard]] VolumeBuffers& buffers_of(std::size_t slot);
    const ShaderProgram& slice_program(const SlabProgramKind& kind);
    const ShaderProgram& edge_program(const SlabProgramKind& kind);

    struct Table {
        GLuint texture = 0;
        bool is_made = false;
        ColorScale scale; // what it was made from
        std::vector<std::array<double, 2>> opacity_points;
    };

    const Gl& gl_;
    ShaderProgram first_part_, next_part_, kept_program_, limits_program_, picture_program_;
    std::map<SlabProgramKind, ShaderProgram> slice_programs_, edge_programs_;
    Sheet parts_[most_ray_parts], kept_, limits_, picture_, together_;
    GLuint query_ = 0, no_array_ = 0;
    GLuint surfaces_ = 0;              // depth of what is opaque, or 0
    std::list<VolumeBuffers> buffers_; // one per volume of the largest frame so far
    std::vector<Table> tables_;        // likewise

    // Of the frame being drawn.
    const Frame* frame_ = nullptr;
    const ViewTransform* transform_ = nullptr;
    GLuint opaque_ = 0;          // depth that volumes end on, or 0
    int width_ = 0, height_ = 0; // of the volume's sheets
};

} // namespace ciel::render
