#include "geometry/color_scale_of.hpp"
#include "geometry/layer_update.hpp"
#include "geometry/volume_cut.hpp"

#include <cmath>

namespace server::geometry {

bool LayerUpdate::operator()(const scene::Layer& layer, const scene::VolumeLayer& volume) {
    VolumeCut& kept = volumes[layer.id];
    const std::size_t before = kept.memory_bytes();
    try {
        kept.use_property(volume.array, out.step, *loaded, out.origin);
    } catch (const store::NotWritten& missing) {
        leave_out(layer, missing);
        return true;
    }
    const ciel::Vec3d normal = slab_normal(slabs_across, camera, moving);
    const store::ScalarField planes = drawn(loaded->plane(out.step, out.origin, normal));
    const std::string place = plane_name(normal, step());
    const auto [low, high] = planes.field->range();
    const double length = double{high} - double{low};
    const std::size_t vertices = kept.values.size();
    const std::size_t slices =
        volume.slices.value_or(usual_slices(length, mean_edge(), vertices, steepness(volume.opacity_points)));
    const double loss = largest_loss(volume.opacity_points, unit_length_of(volume), length);
    const std::size_t stride = moving ? moving_stride(slices, vertices, loss) : 1;
    if (!kept.cut(place, planes, normal, slices, stride, extraction, stop)) return false;
    out.volumes.push_back(drawable_of(layer, volume, kept, stride));
    tell_left_out(volume.array, true);
    count(before, kept.memory_bytes());
    return true;
}

double LayerUpdate::unit_length_of(const scene::VolumeLayer& volume) const {
    return volume.unit_length.value_or(0.1 * diagonal());
}

VolumeDrawable LayerUpdate::drawable_of(const scene::Layer& layer, const scene::VolumeLayer& volume,
                                        const VolumeCut& kept, std::size_t stride) const {
    VolumeDrawable drawable;
    drawable.layer = layer.id;
    drawable.slabs = kept.slabs;
    drawable.stride = stride;
    drawable.value_origin = kept.value_origin;
    drawable.array = full_name(*dataset, volume.array);
    drawable.units = dataset->find(store::parse_scalar(*dataset, volume.array).array)->units;
    drawable.legend_lines = legend_lines(volume.array);
    const auto sound = loaded->sound_cells(volume.array, out.step);
    drawable.all_left_out = sound && sound->left_out == sound->kept.size();
    drawable.scale = color_scale_of(volume.color, range_of(*dataset, volume.array, out.step));
    drawable.opacity_points = volume.opacity_points;
    drawable.unit_length = unit_length_of(volume);
    drawable.shaded = volume.shaded;
    drawable.opacity = layer.opacity;
    drawable.identity = kept.identity;
    drawable.revision = kept.revision;
    return drawable;
}

double LayerUpdate::mean_edge() const {
    double volume = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) volume *= out.bounds_max[axis] - out.bounds_min[axis];
    return std::cbrt(volume);
}

double LayerUpdate::diagonal() const {
    return std::hypot(out.bounds_max[0] - out.bounds_min[0], out.bounds_max[1] - out.bounds_min[1],
                      out.bounds_max[2] - out.bounds_min[2]);
}

} // namespace server::geometry
