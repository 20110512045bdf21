// Draws frames with the GL objects of one context, which exist until the GL context is destroyed.
#pragma once

#include "annotations/camera.hpp"
#include "render/context/pacing.hpp"
#include "render/overlay/overlay_painter.hpp"
#include "render/surfaces/ambient_occlusion.hpp"
#include "render/surfaces/color_scales.hpp"
#include "render/surfaces/depth_peeling.hpp"
#include "render/surfaces/opaque_depth.hpp"
#include "render/surfaces/primitive_buffers.hpp"
#include "render/surfaces/shaders.hpp"
#include "render/surfaces/surface_slopes.hpp"
#include "render/surfaces/transparency.hpp"
#include "render/surfaces/transparent_points.hpp"
#include "render/target/kept_picture.hpp"
#include "render/target/target.hpp"
#include "render/volume/volume_painter.hpp"

#include <list>

namespace server::render {

class Painter {
public:
    explicit Painter(const Gl& gl); // the GL context must be current in all calls
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    // The picture is valid until the next draw. Throws the errors of Renderer::draw, but does not check the memory.
    const Image& draw(const Frame& frame, const AfterStage& after);
    bool pick(int x, int y, ciel::Vec3d& position);
    [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }
    [[nodiscard]] const std::string& renderer_name() const { return renderer_name_; }
    [[nodiscard]] const std::string& version() const { return version_; }

private:
    const Image& draw_paced(const Frame& frame, const AfterStage& after);
    void set_first_state();
    void set_cover_part(float part);
    void enable_clip_planes(bool on);
    void load_scales(const Frame& frame);
    void upload(const Frame& frame);
    [[nodiscard]] TouchedTiles touched_by(const Frame& frame) const;
    void draw_primitives(const Frame& frame, const Program& program, bool before_volume = false);
    void draw_lines(const Frame& frame);
    void draw_opaque_points(const Frame& frame);
    void draw_points(const Frame& frame, const std::vector<std::array<float, 2>>& sample_places);
    void draw_opaque_points_with(const Frame& frame);
    void draw_opaque(const Frame& frame);
    void find_slopes(const Frame& frame);
    void draw_opaque_depth(const Frame& frame, bool with_normals);
    void draw_depths(const Frame& frame, const Program& program);
    void use_occlusion(const Frame& frame);
    void draw_volumes(const Frame& frame);
    void draw_transparent(const Frame& frame);
    [[nodiscard]] float use_in_layers(const Frame& frame, const Program& program, bool joining);
    void draw_lines_of_layer(const Frame& frame, bool joining);
    void draw_points_of_layer(const Frame& frame);
    void draw_points_between_layers(const Frame& frame);
    void use_for_points(const Frame& frame, const Program& program);
    void draw_depth_of_overlays(const Frame& frame);
    void peel_transparent(const Frame& frame);
    void use(const Program& program, const Frame& frame);
    void use_look(const Frame& frame, const Primitives& primitives);
    void use_line(const Program& program, const Primitives& primitives, float factor) const;
    void assign_buffers(const Frame& frame);
    [[nodiscard]] PrimitiveBuffers& buffers(std::size_t index) { return *slots_[index]; }

    Gl gl_;
    Pacing pacing_;
    std::string renderer_name_, version_;
    std::vector<std::string> remarks_;
    Program triangles_, plain_, normals_, occluded_, lines_, points_;
    ColorScales scales_;
    std::vector<ScaleRow> scale_rows_; // one for each element of Frame::primitives
    Target target_;
    KeptPicture picture_;
    OpaqueDepth opaque_depth_;
    AmbientOcclusion occlusion_;
    SurfaceSlopes slopes_;
    std::list<PrimitiveBuffers> buffers_; // grows to the largest number that one frame has needed
    // One for each element of Frame::primitives; null for transparent triangles and transparent points.
    std::vector<PrimitiveBuffers*> slots_;
    TransparentTriangles transparent_;
    TransparentPoints transparent_points_;
    DepthPeeling peeling_;
    VolumePainter volumes_;
    OverlayPainter overlay_;
    annotations::ViewTransform transform_;
    std::size_t clip_planes_ = 0;
    ciel::Vec3d origin_{};
    int width_ = 0, height_ = 0;           // size of the last picture in pixels; 0 if there is no picture for pick()
    bool transparent_depth_drawn_ = false; // whether the target has the depth of transparent triangles, for pick()
};

} // namespace server::render
