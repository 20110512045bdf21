#include "geometry/empty_layers.hpp"

#include "annotations/ticks.hpp"
#include "geometry/clip_planes.hpp"
#include "geometry/layer_update.hpp"
#include "geometry/volume_cut.hpp"

#include <algorithm>

namespace server::geometry {
namespace {

bool is_seen(const Drawable& drawable, const ClipPlanes& cutter) {
    const std::span<const ciel::Index> indices = drawable.indices();
    if (indices.empty() || !cutter.cuts()) return !indices.empty();
    const auto& positions = drawable.shape->surface.positions;
    if (std::any_of(indices.begin(), indices.end(), [&](ciel::Index i) { return cutter.keeps(positions[i]); }))
        return true;
    const std::size_t corners = drawable.corners();
    for (std::size_t i = 0; i + corners <= indices.size(); i += corners) {
        std::vector<ciel::Vec3d> piece;
        for (std::size_t k = 0; k < corners; ++k) piece.push_back(wide(positions[indices[i + k]]));
        if (!cutter.rest_of(std::move(piece)).empty()) return true;
    }
    return false;
}

// Tests each plane alone: several planes that remove all vertices together may leave a part in the middle of a cell.
bool is_seen(const color::SlabTriangles& boundary, const Geometry& geometry) {
    const auto& vertices = boundary.vertices;
    return !vertices.empty() &&
           std::all_of(geometry.clip.begin(), geometry.clip.end(), [&](const ciel::HalfSpace& plane) {
               return std::any_of(vertices.begin(), vertices.end(), [&](const color::SlabVertex& vertex) {
                   return distance(plane, wide(vertex.position)) >= 0;
               });
           });
}

std::string range_text(const std::array<double, 2>& range) {
    const int digits = annotations::digits_of_range(range[0], range[1]);
    return annotations::number_label(range[0], digits) + " to " + annotations::number_label(range[1], digits);
}

struct Absence {
    const Geometry& geometry;
    const store::Dataset& dataset;
    const std::string& id;

    [[nodiscard]] std::string array_goes(const std::string& array) const {
        const auto range = range_of(dataset, array, geometry.step);
        return array + " goes from " + range_text({range[0], range[1]}) + " at this time.";
    }
    EmptyLayer operator()(const scene::IsoLayer& iso) const {
        if (iso.values.empty()) return {id, EmptyLayer::Why::nothing, "The layer has no iso-value."};
        const auto range = range_of(dataset, iso.array, geometry.step);
        const auto is_outside = [&](double value) { return value < range[0] || value > range[1]; };
        if (!std::all_of(iso.values.begin(), iso.values.end(), is_outside))
            return {id, EmptyLayer::Why::nothing, "No cell has values on both sides of an iso-value."};
        const std::string what =
            iso.values.size() == 1 ? annotations::number_label(iso.values[0]) + " is" : "The iso-values are";
        return {id, EmptyLayer::Why::outside, what + " outside the range: " + array_goes(iso.array)};
    }
    EmptyLayer operator()(const scene::SliceLayer&) const {
        return {id, EmptyLayer::Why::outside, "The plane does not cut the data."};
    }
    template <class Kind>
    EmptyLayer operator()(const Kind& layer) const {
        if constexpr (requires { layer.threshold; })
            if (layer.threshold) {
                const std::string& array = layer.threshold->array;
                return {id, EmptyLayer::Why::threshold,
                        "The threshold from " + range_text(layer.threshold->range) +
                            " keeps no cell: " + array_goes(array)};
            }
        return {id, EmptyLayer::Why::nothing, "The data has no geometry of the layer's type."};
    }
};

bool is_transparent(const scene::Layer& layer) {
    if (!(layer.opacity > 0)) return true;
    const auto* volume = std::get_if<scene::VolumeLayer>(&layer.kind);
    return volume != nullptr && std::all_of(volume->opacity_points.begin(), volume->opacity_points.end(),
                                            [](const auto& point) { return !(point[1] > 0); });
}

class Judge {
public:
    Judge(const Geometry& geometry, const store::Dataset& dataset)
        : geometry_(geometry), dataset_(dataset), cutter_(geometry) {}

    [[nodiscard]] std::optional<EmptyLayer> operator()(const scene::Layer& layer) const {
        bool is_there = false;
        bool has_pieces = false, blew_up = false;
        for (const Drawable& drawable : geometry_.drawables) {
            if (drawable.layer != layer.id) continue;
            blew_up = blew_up || drawable.all_left_out;
            has_pieces = has_pieces || !drawable.indices().empty();
            is_there = is_there || (has_pieces && !is_transparent(layer) && is_seen(drawable, cutter_));
        }
        for (const VolumeDrawable& volume : geometry_.volumes) {
            if (volume.layer != layer.id) continue;
            blew_up = blew_up || volume.all_left_out;
            has_pieces = has_pieces || !volume.slabs->boundary->vertices.empty();
            is_there = is_there || (!is_transparent(layer) && is_seen(*volume.slabs->boundary, geometry_));
        }
        if (is_there) return {};
        if (!has_pieces && blew_up)
            return EmptyLayer{layer.id, EmptyLayer::Why::nothing,
                              "No cell of the layer has a number for the array of the layer at this time."};
        if (!has_pieces) return std::visit(Absence{geometry_, dataset_, layer.id}, layer.kind);
        if (is_transparent(layer)) return EmptyLayer{layer.id, EmptyLayer::Why::opacity, "The opacity is 0."};
        return EmptyLayer{layer.id, EmptyLayer::Why::clipped, "The clip planes cut away the whole layer."};
    }

private:
    const Geometry& geometry_;
    const store::Dataset& dataset_;
    ClipPlanes cutter_;
};

bool shows_data(const scene::Layer& layer) {
    return !std::holds_alternative<scene::OutlineLayer>(layer.kind) &&
           !std::holds_alternative<scene::ClipLayer>(layer.kind);
}

} // namespace

std::vector<EmptyLayer> empty_layers(const Geometry& geometry, const scene::CheckedScene& checked) {
    const Judge judge(geometry, *checked.dataset());
    std::vector<EmptyLayer> found;
    for (const scene::Layer& layer : checked.scene().layers) {
        if (!layer.visible || !shows_data(layer) || is_empty(geometry, layer.id)) continue;
        if (auto empty = judge(layer)) found.push_back(std::move(*empty));
    }
    return found;
}

bool is_empty(const Geometry& geometry, const std::string& layer) {
    return std::any_of(geometry.empty.begin(), geometry.empty.end(),
                       [&](const EmptyLayer& empty) { return empty.layer == layer; });
}

std::string why_text(EmptyLayer::Why why) {
    constexpr std::array names{"outside", "threshold", "clipped", "opacity", "missing", "nothing"};
    return names.at(static_cast<std::size_t>(why));
}

} // namespace server::geometry
