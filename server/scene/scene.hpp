// The scene document: everything that a view shows, as one JSON document (components/schemas/Scene in
// protocol/openrpc.json states its form, defaults and limits). A change is an RFC 7396 merge patch.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace ciel::scene {

struct Camera {
    std::array<double, 3> position{}, target{}, up{0, 0, 1};
    double fov = 30; // vertical, degrees
    bool parallel = false;
    double parallel_height = 1; // height of the view in scene units, when parallel
};

using Rgb8 = std::array<std::uint8_t, 3>;

struct ColorPoint {
    double at = 0; // along the range, from 0 to 1
    Rgb8 color{};
};

struct Coloring { // by a scalar through a map, or solid when `array` is empty
    std::string array;
    std::string map = "viridis";
    std::vector<ColorPoint> points;             // empty, or at least two, ascending, which replace the map
    std::optional<std::array<double, 2>> range; // none: the array's at the shown time; above zero if only `log`
    bool reverse = false, symmetric = false, log = false; // symmetric and log: logarithmic on both sides of zero
    int steps = 0;                                        // 0: smooth
    Rgb8 nan{128, 128, 128};
    std::optional<Rgb8> below, above; // none: the color of that end
    std::array<float, 3> solid{0.8F, 0.8F, 0.8F};
};

struct LineStyle { // of polygon edges and contour lines; width in pixels
    std::array<float, 3> color{0x1a / 255.0F, 0x1a / 255.0F, 0x1a / 255.0F};
    float width = 1;
};

struct Contours { // lines of constant value on a slice
    std::string array;
    std::vector<double> values;
    int count = 10; // number of values, evenly spaced in the range; 0 if `values` is given
    std::optional<std::array<double, 2>> range;
    LineStyle line{{0x1a / 255.0F, 0x1a / 255.0F, 0x1a / 255.0F}, 1.5F};
    std::optional<Coloring> coloring; // by value, instead of the line's color
};

struct IsoLayer {
    std::string array;
    std::vector<double> values;
    Coloring color;
    bool smooth = true; // normals from the field's gradient
    std::optional<LineStyle> edges;
};
struct SliceLayer {
    std::array<double, 3> origin{}, normal{1, 0, 0};
    Coloring color;
    std::optional<Contours> contours;
    std::optional<LineStyle> edges;
};
struct Threshold { // cells whose values lie in a range
    std::string array;
    std::array<double, 2> range{};
    bool any = false; // any vertex of a cell is in the range; else all are
};
struct SurfaceLayer { // boundary faces; all of them when `groups` is empty
    std::vector<std::string> groups;
    Coloring color;
    std::optional<Threshold> threshold;
    std::optional<LineStyle> edges;
};
struct OutlineLayer { // the bounding box
    Coloring color;   // its solid color
};

struct ClipLayer {                                   // a plane that cuts all layers
    std::array<double, 3> origin{}, normal{1, 0, 0}; // normal: points to the removed side
    bool caps = true;                                // closes the cuts through the mesh's surface layers
    std::optional<Coloring> color;                   // of the caps; none: the surface layer's
};
inline constexpr std::size_t most_name_bytes = 256; // of a layer id, a title, a gesture; the contract counts characters
inline constexpr std::size_t most_clip_planes = 6;  // visible ones: two fewer than every OpenGL has at least

struct EdgesLayer { // of the boundary's faces
    std::vector<std::string> groups;
    std::optional<Threshold> threshold;
    std::optional<double> angle; // degrees: only edges where the boundary bends by more
    float width = 1.5F;
    Coloring color;
};
struct PointsLayer {  // the mesh's vertices
    bool all = false; // else only those of boundary faces
    std::vector<std::string> groups;
    std::optional<Threshold> threshold;
    float size = 4;
    std::size_t most = 1'000'000;
    Coloring color;
};

// Emission and absorption between the mesh's boundary faces, by one array through one color map and opacity curve.
struct VolumeLayer {
    enum class Direction { automatic, x, y, z, screen };

    std::string array;
    Coloring color; // its map and range
    // (place between the ends of the range, opacity of one unit length along a ray); ascending places.
    std::vector<std::array<double, 2>> opacity_points{{0, 0}, {1, 0.9}};
    std::optional<double> unit_length; // none: a tenth of the bounds' diagonal
    std::optional<std::size_t> slices; // none: chosen by geometry/volume_cut.hpp
    Direction direction = Direction::automatic;
    bool shaded = true;
};

struct Layer {
    std::string id;
    double order = 0;
    bool visible = true;
    float opacity = 1;
    std::variant<IsoLayer, SliceLayer, SurfaceLayer, OutlineLayer, ClipLayer, EdgesLayer, PointsLayer, VolumeLayer>
        kind;
};

struct Annotations { // over the picture
    bool legend = true, triad = true, axes = false, time = false, dataset = false;
    std::string title;
    double scale = 1; // of text and lines
};

struct Light {
    bool on = true;
    float strength = 1;
};
struct AmbientOcclusion {
    bool on = false;
    double radius = 0.1; // of the bounds' diagonal
    float strength = 1;
};
struct Lighting { // of surfaces
    bool on = true;
    float ambient = 1; // strength of the ambient light
    Light headlight, key_light;
    AmbientOcclusion ambient_occlusion;
};

struct Scene {
    std::string dataset;
    double time = 0;                 // the nearest step is shown
    std::optional<Camera> camera;    // none: the default view of the dataset's bounds
    std::string background = "dark"; // "dark", "light" or "#rrggbb"
    Annotations annotations;
    Lighting lighting;
    std::vector<Layer> layers; // sorted by (order, id)
};

// A document breaks a rule. `path` is a JSON pointer (RFC 6901) to the place.
class Invalid : public std::runtime_error {
public:
    Invalid(std::string path_, const std::string& sentence) : std::runtime_error(sentence), path(std::move(path_)) {}
    std::string path;
};

// Throws Invalid. Does not check that arrays exist: that needs the dataset (checked_scene.hpp).
[[nodiscard]] Scene parse(const nlohmann::json& document);
// RFC 7396. Returns the patched document, without nulls in members that the patch sets: null and absent mean the same
// in a scene. The caller parses it before it replaces the old one.
[[nodiscard]] nlohmann::json merge_patch(nlohmann::json document, const nlohmann::json& patch);
// Returns the merge patch that turns `from` into `to`, as undo sends it. `to` must have no nulls.
[[nodiscard]] nlohmann::json diff(const nlohmann::json& from, const nlohmann::json& to);

} // namespace ciel::scene
