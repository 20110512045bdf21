// The scene document: everything a viewer wants to see, as one JSON document (components/schemas/Scene in
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
    double parallel_height = 1; // of the view, in scene units, when parallel
};

using Rgb8 = std::array<std::uint8_t, 3>;

struct ColorPoint {
    double at = 0; // along the range, from 0 to 1
    Rgb8 color{};
};

struct Coloring { // by a scalar through a map, or solid when `array` is empty
    std::string array;
    std::string map = "viridis";
    std::vector<ColorPoint> points;             // none, or two and more in ascending order, which are the map then
    std::optional<std::array<double, 2>> range; // none: the array's at the shown time; above zero when `log` alone
    bool reverse = false, symmetric = false, log = false; // both: logarithmic on either side of zero
    int steps = 0;                                        // 0: smooth
    Rgb8 nan{128, 128, 128};
    std::optional<Rgb8> below, above; // none: the color of that end
    std::array<float, 3> solid{0.8F, 0.8F, 0.8F};
};

struct LineStyle { // of polygon edges and the like: one color, a width in pixels
    std::array<float, 3> color{0x1a / 255.0F, 0x1a / 255.0F, 0x1a / 255.0F};
    float width = 1;
};

struct Contours { // where an array takes values on a slice
    std::string array;
    std::vector<double> values;
    int count = 10; // of values evenly inside the range; 0 where `values` says it
    std::optional<std::array<double, 2>> range;
    LineStyle line{{0x1a / 255.0F, 0x1a / 255.0F, 0x1a / 255.0F}, 1.5F};
    std::optional<Coloring> coloring; // by their values, instead of the line's color
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
    bool any = false; // of a cell's vertices; else all
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
    std::array<double, 3> origin{}, normal{1, 0, 0}; // the normal points to what is cut away
    bool caps = true;                                // where it cuts the mesh's surface layers open
    std::optional<Coloring> color;                   // of the caps; none: the surface layer's
};
inline constexpr std::size_t most_name_bytes = 256; // of a layer id, a title, a gesture; the contract counts characters
inline constexpr std::size_t most_clip_planes = 6;  // visible ones: what every OpenGL has at least, less two

struct EdgesLayer { // of the boundary's faces
    std::vector<std::string> groups;
    std::optional<Threshold> threshold;
    std::optional<double> angle; // degrees: only where the boundary bends by more
    float width = 1.5F;
    Coloring color;
};
struct PointsLayer {  // the mesh's vertices
    bool all = false; // else those of the boundary's faces
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
    // (place between the ends of the range, opacity of a ray that runs one unit length through this value); ascending.
    std::vector<std::array<double, 2>> opacity_points{{0, 0}, {1, 0.9}};
    std::optional<double> unit_length; // none: a tenth of the bounds' diagonal
    std::optional<std::size_t> slices; // none: as geometry/volume_cut.hpp finds fitting
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
    float ambient = 1; // strength of the light from everywhere
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

// What is wrong and where: `path` is a JSON pointer (RFC 6901) into the document.
class Invalid : public std::runtime_error {
public:
    Invalid(std::string path_, const std::string& sentence) : std::runtime_error(sentence), path(std::move(path_)) {}
    std::string path;
};

// Throws Invalid. Says nothing about whether arrays exist: that needs the dataset (session/).
[[nodiscard]] Scene parse(const nlohmann::json& document);
// RFC 7396. Returns the patched document; the caller parses it before it replaces the old one. What it returns holds no
// nulls where the patch reached: null and absent mean the same in a scene.
[[nodiscard]] nlohmann::json merge_patch(nlohmann::json document, const nlohmann::json& patch);
// The patch that leads from one document to another: what undo sends back. `to` must hold no nulls.
[[nodiscard]] nlohmann::json diff(const nlohmann::json& from, const nlohmann::json& to);

} // namespace ciel::scene
