#include "scene/rules.hpp"

#include "ciel/printable.hpp"
#include "scene/contract.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

namespace server::scene {
namespace {

// The contract's maxLength counts characters, which have up to four bytes.
void check_name(const std::string& name, const std::string& path, const char* what) {
    if (name.size() > most_name_bytes)
        throw Invalid(path, std::string(what) + " may have at most " + std::to_string(most_name_bytes) +
                                " bytes of UTF-8; shorten it");
}

void check_camera(const Camera& camera) {
    if (camera.position == camera.target)
        throw Invalid("/camera/position", "the camera's position and target must differ");
    if (camera.up == Vec3{}) throw Invalid("/camera/up", "the camera's up direction must not be zero");
    if (camera.parallel && !camera.parallel_height)
        throw Invalid("/camera/parallel_height", "a parallel camera needs parallel_height, the height of the view");
}

void check_range(const Range& range, const std::string& path) {
    if (range[0] > range[1])
        throw Invalid(path + "/range", "a range must be [minimum, maximum] with minimum <= maximum");
}

void check_points(const std::vector<ColorPoint>& points, const std::string& path) {
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i].at < points[i - 1].at)
            throw Invalid(path + "/points/" + std::to_string(i) + "/at",
                          "the points of a color map must be in ascending order of at");
}

void check_coloring(const Coloring& coloring, const std::string& path) {
    if (coloring.points) check_points(*coloring.points, path);
    if (!coloring.range) return;
    check_range(*coloring.range, path);
    if (coloring.log && !coloring.symmetric && (*coloring.range)[0] <= 0)
        throw Invalid(path + "/range", "a logarithmic scale cannot show zero or negative values; give a range that "
                                       "begins above zero, add symmetric, or leave out log");
}

template <class Style>
void drop_hidden(std::optional<Style>& style) {
    if (style && !style->visible) style.reset();
}

void resolve_contours(std::optional<Contours>& contours, const std::string& path) {
    drop_hidden(contours);
    if (!contours) return;
    if (contours->values && (contours->count || contours->range))
        throw Invalid(path, "contours must have either values, or count and range, but not both");
    if (!contours->values && !contours->count) contours->count = Contours::default_count;
    if (contours->range) check_range(*contours->range, path);
    if (!contours->coloring) return;
    check_coloring(*contours->coloring, path + "/coloring");
    std::string& array = contours->coloring->array;
    if (array.empty()) array = contours->array;
    if (array != contours->array)
        throw Invalid(path + "/coloring/array", "contour lines of " + ciel::printable(contours->array) +
                                                    " have the colors of its values, not of " + ciel::printable(array) +
                                                    "; leave out array in coloring");
}

void resolve_threshold(std::optional<Threshold>& threshold, const std::string& path) {
    if (threshold && !threshold->enabled) threshold.reset();
    if (threshold) check_range(threshold->range, path + "/threshold");
}

template <class WithPlane>
Plane plane_along(const WithPlane& layer) {
    Plane plane;
    if (layer.axis) {
        const auto axis = static_cast<std::size_t>(*layer.axis);
        plane.normal[axis] = 1;
        plane.origin[axis] = *layer.value;
        return plane;
    }
    plane.origin = *layer.origin;
    plane.normal = *layer.normal;
    const double length = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
    for (double& component : plane.normal) component /= length;
    return plane;
}

template <class WithPlane>
void check_plane(const WithPlane& layer, const std::string& path) {
    const bool by_axis = layer.axis && layer.value && !layer.origin && !layer.normal;
    const bool by_plane = !layer.axis && !layer.value && layer.origin && layer.normal;
    if (!by_axis && !by_plane)
        throw Invalid(path, std::string("a ") + layer.type + " must have either axis and value, or origin and normal");
    if (by_axis) return;
    const double length = std::hypot((*layer.normal)[0], (*layer.normal)[1], (*layer.normal)[2]);
    if (!(length > 0) || !std::isfinite(length))
        throw Invalid(path + "/normal", std::string("a ") + layer.type + "'s normal must not be zero");
}

struct Rules {
    std::string path; // JSON pointer of the layer

    void operator()(IsoLayer& iso) const {
        check_coloring(iso.color, path + "/color");
        drop_hidden(iso.edges);
    }
    void operator()(SliceLayer& slice) const {
        check_coloring(slice.color, path + "/color");
        resolve_contours(slice.contours, path + "/contours");
        drop_hidden(slice.edges);
        check_plane(slice, path);
    }
    void operator()(SurfaceLayer& surface) const {
        check_coloring(surface.color, path + "/color");
        resolve_threshold(surface.threshold, path);
        drop_hidden(surface.edges);
    }
    void operator()(OutlineLayer& outline) const { check_coloring(outline.color, path + "/color"); }
    void operator()(ClipLayer& clip) const {
        check_plane(clip, path);
        if (clip.color) check_coloring(*clip.color, path + "/color");
    }
    void operator()(EdgesLayer& edges) const {
        resolve_threshold(edges.threshold, path);
        check_coloring(edges.color, path + "/color");
    }
    void operator()(PointsLayer& points) const {
        if (points.of == PointsLayer::Of::all && !points.groups.empty())
            throw Invalid(path + "/groups",
                          "groups chooses points of the boundary only; leave out groups or \"of\": \"all\"");
        resolve_threshold(points.threshold, path);
        check_coloring(points.color, path + "/color");
    }
    void operator()(VolumeLayer& volume) const {
        check_coloring(volume.color, path + "/color");
        for (std::size_t i = 1; i < volume.opacity_points.size(); ++i)
            if (volume.opacity_points[i][0] < volume.opacity_points[i - 1][0])
                throw Invalid(path + "/opacity_points/" + std::to_string(i),
                              "opacity points must be in ascending order of their positions");
        if (!volume.color.array.empty() && volume.color.array != volume.array)
            throw Invalid(path + "/color/array",
                          "a volume must have the colors of its own array, " + ciel::printable(volume.array));
    }
};

void check_clip_planes(const std::vector<Layer>& layers) {
    std::size_t planes = 0;
    for (const Layer& layer : layers)
        if (layer.visible && std::holds_alternative<ClipLayer>(layer.kind) && ++planes > most_clip_planes)
            throw Invalid(pointer_step("/layers", layer.id),
                          "at most " + std::to_string(most_clip_planes) +
                              " clip planes can be visible at a time; hide or remove a clip layer");
}

} // namespace

Plane plane_of(const SliceLayer& slice) { return plane_along(slice); }

Plane plane_of(const ClipLayer& clip) {
    Plane plane = plane_along(clip);
    if (clip.invert)
        for (double& component : plane.normal) component = -component;
    return plane;
}

void refuse_old_legend(const nlohmann::json& document) {
    if (document.is_object() && document.contains("legend"))
        throw Invalid(
            "/legend",
            "/legend is not a member of a scene; use annotations.legend: {\"annotations\": {\"legend\": true}}");
}

void apply_rules(Scene& scene) {
    check_name(scene.annotations.title, "/annotations/title", "a title");
    if (scene.camera) check_camera(*scene.camera);
    for (Layer& layer : scene.layers) {
        check_name(layer.id, "/layers", "a layer's id");
        std::visit(Rules{pointer_step("/layers", layer.id)}, layer.kind);
    }
    std::ranges::sort(scene.layers, std::ranges::less(),
                      [](const Layer& layer) { return std::tie(layer.order, layer.id); });
    check_clip_planes(scene.layers);
}

} // namespace server::scene
