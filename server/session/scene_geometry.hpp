// From a scene to what is drawn: one kernel Query per iso-value and slice, kept from one scene to the next, so that
// only what changed is computed again.
#pragma once

#include "ciel/clip_surface.hpp"
#include "ciel/extract.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"
#include "store/loaded.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace ciel::session {

// Positions are offsets from Geometry::origin. A boundary surface has points with a == b: a mesh vertex itself.
struct Shape {
    Surface surface;
    std::vector<Index> indices; // three per triangle, two per line, one per point
    bool lines = false, points = false;
};

struct Drawable { // one iso-value, slice, boundary surface or outline of a layer, or the edges of its polygons
    std::string layer;
    std::shared_ptr<const Shape> shape;
    std::shared_ptr<const std::vector<Index>> edges;   // drawn instead of the shape's own indices, two per line
    float line_width = 1.5F;                           // pixels
    std::shared_ptr<const std::vector<float>> scalars; // one per surface vertex; null: the solid colour
    std::string array;                                 // of the scalars
    std::string units;                                 // of the array, empty where not known
    std::vector<std::string> legend_lines;             // what a legend says of the array at this step besides
    render::ColorScale scale;                          // of the scalars
    bool missing = false;                              // some of the scalars are no numbers
    bool all_left_out = false;                         // its polygons were all of cells that blew up
    std::array<float, 4> color{0.8F, 0.8F, 0.8F, 1};   // alpha: the layer's opacity
    bool lit = true;
    bool contours = false;      // lines on the layer, whose colours are on a scale of their own
    std::uint64_t identity = 0; // the same from one scene to the next, unique in the process
    std::uint64_t revision = 0; // changes with shape and scalars, unique in the process

    [[nodiscard]] bool lines() const { return edges != nullptr || shape->lines; }
    [[nodiscard]] bool points() const { return edges == nullptr && shape->points; }
    [[nodiscard]] bool is_on_surface() const { return edges != nullptr || contours; } // that of its own layer
    [[nodiscard]] bool polygons() const { return !lines() && !points(); }
    [[nodiscard]] std::span<const Index> indices() const { return edges ? *edges : shape->indices; }
};

struct Slabs; // volume_cut.hpp

struct VolumeDrawable {
    std::string layer;
    std::shared_ptr<const Slabs> slabs;
    std::size_t stride = 1; // one slice in so many is drawn
    std::string array, units;
    std::vector<std::string> legend_lines;
    bool all_left_out = false;
    render::ColorScale scale;
    std::vector<std::array<double, 2>> opacity_points; // as in the scene
    double unit_length = 1;
    bool shaded = true;
    float opacity = 1;
    std::uint64_t identity = 0, revision = 0; // as a Drawable's, of the slabs
};

struct EmptyLayer { // one that is switched on and shows nothing
    enum class Why { outside, threshold, clipped, opacity, missing, nothing };

    std::string layer;
    Why why = Why::nothing;
    std::string reason; // a sentence about "it", the layer
    bool operator==(const EmptyLayer&) const = default;
};
[[nodiscard]] std::string why_text(EmptyLayer::Why why); // as in the contract

struct BoundingBox { // in the dataset's coordinates
    Vec3d low{}, high{};
    bool operator==(const BoundingBox&) const = default;
};

// What one scene shows. Immutable, owns all its arrays, may be read from any thread.
struct Geometry {
    std::vector<Drawable> drawables;     // visible layers, in drawing order
    std::vector<VolumeDrawable> volumes; // likewise
    std::vector<HalfSpace> clip;         // cut all volumes, and all drawables, which are whole (clip.hpp); of offsets
    Vec3d origin{}, bounds_min{}, bounds_max{};
    Vec3d file_origin{}; // of surfaces in files (wire/surface_files.hpp): the first mesh's, whatever is shown
    double time = 0;     // of the step shown
    std::size_t step = 0;
    std::string length_units; // empty where not known
    std::size_t triangles = 0, bytes = 0;
    // A sentence for each layer that is left out, or left uncoloured, because its array was not written at this step.
    std::vector<std::string> lacking;
    std::vector<std::string> remarks; // likewise what is shown in another way than was asked for, or in part
    std::vector<EmptyLayer> empty;    // those have no legend either
};
[[nodiscard]] bool is_empty(const Geometry& geometry, const std::string& layer);

// Throws store::NotWritten when something is lacking: for files of surfaces, which have no place for a remark.
void require_complete(const Geometry& geometry);

struct Cut; // cut.hpp
struct Boundary;
struct VolumeCut;

// Not thread-safe: one at a time.
class SceneGeometry {
public:
    explicit SceneGeometry(Extraction extraction);
    ~SceneGeometry();
    SceneGeometry(SceneGeometry&&) noexcept;
    SceneGeometry& operator=(SceneGeometry&&) noexcept;

    // Brings the geometry to `scene`, whose dataset `loaded` is. Returns null when `stop` was requested. Throws Error,
    // scene::Invalid, or LimitReached as soon as what is kept needs more than `most_bytes`, which it passes by one
    // surface at most; it can be called again with another scene then. `moving`: for a picture that others will follow
    // at once.
    [[nodiscard]] std::shared_ptr<const Geometry> update(const scene::Scene& scene,
                                                         const std::shared_ptr<store::LoadedDataset>& loaded,
                                                         const std::stop_token& stop = {},
                                                         std::size_t most_bytes = SIZE_MAX, bool moving = false);
    [[nodiscard]] std::size_t memory_bytes() const; // query state and surfaces

private:
    using Key = std::pair<std::string, std::size_t>; // layer id, index of the value
    void forget_all_but(const scene::Scene& scene);

    Extraction extraction_;
    std::shared_ptr<store::LoadedDataset> loaded_;
    std::map<Key, Cut> cuts_;
    std::map<Key, Boundary> boundaries_;
    std::map<std::string, VolumeCut> volumes_; // by layer
};

// Borrows from `geometry`. samples: of a pixel. Without a camera in the scene it looks from as far as what is
// written over pictures needs (render/annotations/make_room.hpp), though it carries none of it.
[[nodiscard]] render::Frame frame_of(const Geometry& geometry, const scene::Scene& scene, int width, int height,
                                     int samples);
// Of the whole of the bounds, or of a box in them, beside what is written over pictures of that shape.
[[nodiscard]] render::Camera default_view(const Geometry& geometry, const scene::Scene& scene, int width, int height,
                                          double fov_degrees = render::Camera{}.fov_degrees, bool parallel = false,
                                          const std::optional<BoundingBox>& of = {});
// The scene's, or the default view of the bounds.
[[nodiscard]] render::Camera camera_of(const Geometry& geometry, const scene::Scene& scene, double aspect);

// Throws scene::Invalid when the scene names an array, patch or colour map that does not exist.
void check_names(const scene::Scene& scene, const store::Dataset& dataset);

} // namespace ciel::session
