// Draws volumes: blends their slabs from back to front in floats, and composites the result onto the picture.
#pragma once

#include "annotations/camera.hpp"
#include "render/target/target.hpp"
#include "render/volume/slab_shaders.hpp"
#include "render/volume/volume_buffers.hpp"
#include "render/volume/volume_coverage.hpp"
#include "render/volume/volume_order.hpp"
#include "render/volume/volume_rays.hpp"
#include "render/volume/volume_reach.hpp"

#include <functional>
#include <list>
#include <map>

namespace server::render {

// The GL objects exist until the GL context is destroyed.
class VolumePainter {
public:
    explicit VolumePainter(const Gl& gl);
    VolumePainter(const VolumePainter&) = delete;
    VolumePainter& operator=(const VolumePainter&) = delete;

    // Sets the texture with the window depths at which rays end in later draws. 0: rays do not end on surfaces.
    void end_on(GLuint depth) { surfaces_ = depth; }
    // Leaves the target bound, and depth test and blending on. Throws Error if the volumes' normals differ or their
    // slabs are not finite. Throws the errors of VolumeBuffers::load(), too.
    void draw(const Frame& frame, const annotations::ViewTransform& transform, Target& target);
    // Returns a texture (RGBA32F, premultiplied) with all volumes in front of `layer`. The texture is valid until the
    // next call, and only at the pixels of the layer. If the textures of `layer` are 0, the result has all volumes in
    // front of opaque surfaces and is valid at all pixels. Throws the errors of draw(). Binds another framebuffer,
    // changes the viewport, and leaves depth test and blending on.
    [[nodiscard]] GLuint picture_until(const Frame& frame, const annotations::ViewTransform& transform,
                                       const LayerInVolumes& layer);
    // Returns an RGBA32F texture. A: window depth at which the volumes begin. Returns 0 before a volume is drawn.
    [[nodiscard]] GLuint limits() const { return rays_.begin_of_all(); }

private:
    struct Table {
        GLuint texture = 0;
        bool is_made = false;
        color::ColorScale scale; // scale, opacity_points, share: inputs from which the texture was made
        std::vector<std::array<double, 2>> opacity_points;
        double share = 1;
        double densest = 0; // largest extinction per unit length
    };
    struct Slot { // GL objects of one volume
        explicit Slot(const Gl& gl) : all(gl), some(gl) {}
        // Interactive pictures draw only some slices (stride > 1). With two sets of buffers, nothing is uploaded when
        // the camera starts or stops moving.
        VolumeBuffers all, some;
        Table table;
        // Programs in which this volume's uniforms are set.
        std::map<SlabProgramKind, ShaderProgram> slice_programs, inner_programs, edge_programs;
        // These members are set for each frame.
        VolumeBuffers* buffers = nullptr;
        const RaySheets* rays = nullptr;
        const ShaderProgram *slice = nullptr, *inner = nullptr, *edge = nullptr;
    };

    // The coordinate of a ray along the slabs' normal is start + depth * per_depth. Both members are linear functions
    // of the pixel: (value at the picture's corner, change per pixel in x, change per pixel in y).
    struct RaysAcross {
        glm::dvec3 per_depth, start;
    };

    void draw_each(const Frame& frame, const annotations::ViewTransform& transform, const LayerInVolumes& layer,
                   const std::function<void()>& bind_picture, bool per_sample);
    void begin_picture(const Frame& frame, const LayerInVolumes& layer);
    [[nodiscard]] Slot& slot_of(std::size_t volume);
    void load_buffers(const Frame& frame);
    void prepare(const Volume& volume, Slot& slot, double share);
    void load_table(const Volume& volume, Table& table, double share);
    void use_programs(const Volume& volume, Slot& slot);
    void set_rays(const ShaderProgram& program, const Volume& volume) const;
    [[nodiscard]] RaysAcross rays_across(const Volume& volume) const;
    void find_coverage(const Frame& frame);
    void set_light(const ShaderProgram& program, const Volume& volume) const;
    void draw_slabs(const Frame& frame, const LayerInVolumes& layer);
    [[nodiscard]] SlabPieces pieces_of_slabs(const Frame& frame) const;
    static void thin_out(const Volume& volume, const Slot& slot, double share);
    void set_slice(const ShaderProgram& program, const Volume& volume, double place) const;
    static void use_edge(const Volume& volume, const Slot& slot, std::size_t slab, double place);
    void draw_ranges(const VolumeBuffers& buffers, const std::vector<BoxedRange>& ranges) const;
    void draw_slab_until(const Volume& volume, const Slot& slot, std::size_t slab) const;
    void draw_slab(const Volume& volume, const Slot& slot, std::size_t slab) const;
    [[nodiscard]] bool has_coverage() const;
    [[nodiscard]] bool is_full(const Volume& volume, double from_eye) const;
    [[nodiscard]] glm::vec4 half_of_slab(const Volume& volume, double from_eye) const; // value of the uniform `half_of`
    [[nodiscard]] double eye_across(const Frame& frame) const;
    void put_on_picture(float opacity, bool coarse, bool per_sample) const;

    const Gl& gl_;
    ShaderProgram picture_program_, sample_program_, coarse_program_;
    VolumeRays rays_;
    VolumeReach reach_;
    VolumeCoverage coverage_;
    struct Covered { // inputs of the coverage, which is reused if its inputs are equal
        RayPlaces places;
        int samples = 0;
        std::vector<std::array<float, 4>> clip;
        std::vector<std::uint64_t> boundaries;
        bool operator==(const Covered&) const = default;
    } covered_;
    Sheet picture_, together_;
    GLuint no_array_ = 0;
    GLuint surfaces_ = 0;   // window depths of opaque surfaces, or 0
    std::list<Slot> slots_; // one per volume of the largest frame so far
    VolumeView view_;
    double slab_angle_ = 0;
};

} // namespace server::render
