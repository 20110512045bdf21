#include "session/sound_shape.hpp"

#include "ciel/threshold_surface.hpp"
#include "session/cut.hpp"

#include <algorithm>

namespace ciel::session {

std::shared_ptr<const Shape> sound_shape(const std::shared_ptr<const Shape>& shape, std::span<const std::string> arrays,
                                         std::size_t step, store::LoadedDataset& loaded) {
    if (shape->lines || shape->points) return shape;
    auto sound = shape;
    for (const std::string& array : arrays) {
        const auto cells = array.empty() ? nullptr : loaded.sound_cells(array, step);
        if (!cells) continue;
        const auto is_kept = [&](Index cell) { return cell < cells->kept.size() && cells->kept[cell] != 0; };
        if (std::ranges::all_of(sound->surface.polygon_cell, is_kept)) continue;
        sound = triangles_shape(polygons_of_cells(sound->surface, cells->kept));
    }
    return sound;
}

std::string left_out_text(const std::string& array, std::size_t step, store::LoadedDataset& loaded) {
    const auto cells = loaded.sound_cells(array, step);
    if (!cells) return {};
    const bool one = cells->left_out == 1;
    return std::to_string(cells->left_out) + (one ? " cell has" : " cells have") + " no number for " + array +
           " at this time and " + (one ? "is" : "are") + " left out";
}

} // namespace ciel::session
