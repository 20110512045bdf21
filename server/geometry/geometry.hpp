// Content of a scene: surfaces, lines, points and slabs of volumes, with their drawing attributes.
#pragma once

#include "ciel/clip_surface.hpp"
#include "ciel/extract.hpp"
#include "color/color_scale.hpp"
#include "store/loaded.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace server::geometry {

// Positions are offsets from Geometry::origin. Points of a boundary surface are mesh vertices: EdgePoint::a ==
// EdgePoint::b.
struct Shape {
    ciel::Surface surface;
    std::vector<ciel::Index> indices; // three per triangle, two per line, one per point
    bool lines = false, points = false;
};

struct Drawable { // one iso-value, slice, boundary surface or outline of a layer, or the edges of its polygons
    std::string layer;
    std::shared_ptr<const Shape> shape;
    std::shared_ptr<const std::vector<ciel::Index>> edges; // drawn instead of the shape's own indices, two per line
    float line_width = 1.5F;                               // pixels
    std::optional<store::Values> scalars;                  // one per surface vertex; nullopt if the color is solid
    double scalar_origin = 0;                              // subtracted from double scalars to draw them as floats
    std::string array;                                     // of the scalars
    std::string units;                                     // of the array; empty if not known
    std::vector<std::string> legend_lines;                 // more lines for the legend, about the array at this step
    color::ColorScale scale;                               // of the scalars
    bool missing = false;                                  // true if some scalars are NaN or infinite
    bool all_left_out = false;                       // all polygons are left out: no cell is sound (sound_shape.hpp)
    std::array<float, 4> color{0.8F, 0.8F, 0.8F, 1}; // alpha: the layer's opacity
    bool lit = true;
    bool contours = false;      // contour lines on the layer, with their own color scale
    std::uint64_t identity = 0; // the same in successive scenes; unique in the process
    std::uint64_t revision = 0; // changes when shape or scalars change; unique in the process

    [[nodiscard]] bool lines() const { return edges != nullptr || shape->lines; }
    [[nodiscard]] bool points() const { return edges == nullptr && shape->points; }
    [[nodiscard]] bool is_on_surface() const { return edges != nullptr || contours; } // on the layer's surface
    [[nodiscard]] bool polygons() const { return !lines() && !points(); }
    [[nodiscard]] std::size_t corners() const { return lines() ? 2 : points() ? 1 : 3; } // of each primitive
    [[nodiscard]] std::span<const ciel::Index> indices() const { return edges ? *edges : shape->indices; }
};

struct Slabs; // volume_cut.hpp

struct VolumeDrawable {
    std::string layer;
    std::shared_ptr<const Slabs> slabs;
    std::size_t stride = 1;  // every `stride`-th slice is drawn
    double value_origin = 0; // the values of the slabs are relative to this number
    std::string array, units;
    std::vector<std::string> legend_lines;
    bool all_left_out = false;
    color::ColorScale scale;
    std::vector<std::array<double, 2>> opacity_points; // as in the scene
    double unit_length = 1;
    bool shaded = true;
    float opacity = 1;
    std::uint64_t identity = 0, revision = 0; // of the slabs; as in Drawable
};

struct EmptyLayer { // a visible layer that shows nothing
    enum class Why { outside, threshold, clipped, opacity, missing, nothing };

    std::string layer;
    Why why = Why::nothing;
    std::string reason; // a sentence that does not name the layer
    bool operator==(const EmptyLayer&) const = default;
};
[[nodiscard]] std::string why_text(EmptyLayer::Why why); // name in protocol/openrpc.json

struct BoundingBox { // in the dataset's coordinates
    ciel::Vec3d low{}, high{};
    bool operator==(const BoundingBox&) const = default;
};

// Content of one scene. Immutable, owns all its arrays, may be read from any thread.
struct Geometry {
    std::vector<Drawable> drawables;     // visible layers, in drawing order
    std::vector<VolumeDrawable> volumes; // visible volumes, in drawing order
    std::vector<ciel::HalfSpace> clip;   // relative to `origin`; drawables and volumes are stored unclipped (clip.hpp)
    ciel::Vec3d origin{}; // the middle of the mesh, or a point near the camera's target (drawing_origin.hpp)
    ciel::Vec3d bounds_min{}, bounds_max{};
    bool double_positions = false;             // whether the mesh has double positions
    std::array<double, 6> first_mesh_bounds{}; // of the dataset's first mesh, at every step: x0, x1, y0, y1, z0, z1
    double time = 0;                           // time of the step shown
    std::size_t step = 0;
    std::string length_units; // empty if not known
    std::size_t triangles = 0;
    std::size_t bytes = 0; // size of the surfaces and of what SceneGeometry keeps for the next scene
    // One sentence per layer that is left out or uncolored because its array has no usable values at this step.
    std::vector<std::string> lacking;
    std::string awaited; // why a layer waits for arrays that are being read from the source; empty: no layer waits
    std::vector<std::string> remarks; // one sentence per item of the scene that is shown differently or only partly
    std::vector<EmptyLayer> empty;    // visible layers that show nothing; they have no legend
};
[[nodiscard]] bool is_empty(const Geometry& geometry, const std::string& layer);

// Throws store::NotYetRead if a layer waits for arrays that are being read from the source.
void require_read(const Geometry& geometry);
// Throws like require_read, and store::NotWritten if `lacking` is not empty: a surface file cannot contain a remark.
void require_complete(const Geometry& geometry);

} // namespace server::geometry
