// Draws volumes over the current picture. Finds which parts of the rays are inside the meshes, blends the slabs of all
// volumes from back to front in floats (in bytes for benchmarks), and composites the result onto the picture.
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

namespace ciel::render {

// GL objects are freed only with their context.
class VolumePainter {
public:
    explicit VolumePainter(const Gl& gl);
    VolumePainter(const VolumePainter&) = delete;
    VolumePainter& operator=(const VolumePainter&) = delete;

    // Sets the texture of window depths at which rays end from now on; 0: rays do not end.
    void end_on(GLuint depth) { surfaces_ = depth; }
    // Draws the volumes onto the target. Leaves the target bound, and depth test and blending on. Throws Error when the
    // volumes' normals differ, when their slabs are at places that are not finite, and as VolumeBuffers::load().
    void draw(const Frame& frame, const annotations::ViewTransform& transform, Target& target);
    // Returns a picture of all volumes in front of `layer`. It is valid at the layer's pixels only, until the next
    // call. Without a layer: a picture of all volumes in front of opaque surfaces, valid everywhere. RGBA32F,
    // premultiplied, on a transparent background. Throws as draw(). Leaves another framebuffer and viewport bound,
    // depth test and blending on.
    [[nodiscard]] GLuint picture_until(const Frame& frame, const annotations::ViewTransform& transform,
                                       const LayerInVolumes& layer);
    // RGBA32F texture; A: the window depth where the volumes begin. 0 before the first volume.
    [[nodiscard]] GLuint limits() const { return rays_.begin_of_all(); }

private:
    struct Table {
        GLuint texture = 0;
        bool is_made = false;
        color::ColorScale scale; // scale, opacity_points, share: inputs of the texture
        std::vector<std::array<double, 2>> opacity_points;
        double share = 1;
        double densest = 0; // largest extinction per unit length
    };
    struct Slot { // GL objects of one volume
        explicit Slot(const Gl& gl) : all(gl), some(gl) {}
        // Buffers of all slices, and of those drawn while something moves. With two sets, starting and stopping a
        // movement uploads nothing.
        VolumeBuffers all, some;
        Table table;
        // Programs in which this volume's uniforms are set.
        std::map<SlabProgramKind, ShaderProgram> slice_programs, inner_programs, edge_programs;
        // Set for the frame being drawn.
        VolumeBuffers* buffers = nullptr;
        const RaySheets* rays = nullptr;
        const ShaderProgram *slice = nullptr, *inner = nullptr, *edge = nullptr;
    };

    // Coordinate along the slabs' normal at a depth of a ray: start + depth * per_depth. Both members are (value at the
    // picture's corner, change per pixel in x, change per pixel in y).
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
    [[nodiscard]] glm::vec4 half_of_slab(const Volume& volume, double from_eye) const; // uniform of the inner program
    [[nodiscard]] double eye_across(const Frame& frame) const;
    void put_on_picture(float opacity, bool coarse, bool per_sample) const;

    const Gl& gl_;
    ShaderProgram picture_program_, sample_program_, coarse_program_;
    VolumeRays rays_;
    VolumeReach reach_;
    VolumeCoverage coverage_;
    struct Covered { // inputs of the coverage, to reuse it
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
    // Set for the frame being drawn.
    VolumeView view_;
    double slab_angle_ = 0; // result of slab_angle()
};

} // namespace ciel::render
