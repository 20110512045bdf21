// The scene document: everything a viewer wants to see, as one JSON document (components/schemas/Scene in
// protocol/openrpc.json states its form, defaults and limits). A change is an RFC 7396 merge patch.
#pragma once

#include <array>
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

struct Coloring { // by a scalar through a map, or solid when `array` is empty
    std::string array;
    std::string map = "viridis";
    std::optional<std::array<double, 2>> range; // none: the array's range at the shown time
    std::array<float, 3> solid{0.8F, 0.8F, 0.8F};
};

struct IsoLayer {
    std::string array;
    std::vector<double> values;
    Coloring color;
    bool smooth = true; // normals from the field's gradient
};
struct SliceLayer {
    std::array<double, 3> origin{}, normal{1, 0, 0};
    Coloring color;
};
struct SurfaceLayer { // boundary faces; all of them when `groups` is empty
    std::vector<std::string> groups;
    Coloring color;
};
struct OutlineLayer { // the bounding box
    Coloring color;   // its solid colour
};

// Emission and absorption between the mesh's boundary faces, by one array through one colour map and opacity curve.
struct VolumeLayer {
    enum class Direction { automatic, x, y, z, screen };

    std::string array;
    Coloring color; // its map and range
    // (place between the ends of the range, opacity of a ray that runs one unit length through this value); ascending.
    std::vector<std::array<double, 2>> opacity_points{{0, 0}, {1, 0.9}};
    std::optional<double> unit_length; // none: a tenth of the bounds' diagonal
    std::size_t slices = 200;
    Direction direction = Direction::automatic;
    bool shaded = true;
};

struct Layer {
    std::string id;
    double order = 0;
    bool visible = true;
    float opacity = 1;
    std::variant<IsoLayer, SliceLayer, SurfaceLayer, OutlineLayer, VolumeLayer> kind;
};

struct Scene {
    std::string dataset;
    double time = 0;                 // the nearest step is shown
    std::optional<Camera> camera;    // none: the default view of the dataset's bounds
    std::string background = "dark"; // "dark", "light" or "#rrggbb"
    bool legend = true;
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
