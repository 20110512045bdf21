#include "geometry/sound_shape.hpp"

#include "ciel/threshold_surface.hpp"
#include "geometry/cut.hpp"

#include <algorithm>

namespace server::geometry {

std::shared_ptr<const Shape> sound_shape(const std::shared_ptr<const Shape>& shape, std::span<const std::string> arrays,
                                         std::size_t step, store::LoadedDataset& loaded) {
    if (shape->lines || shape->points) return shape;
    auto sound = shape;
    for (const std::string& array : arrays) {
        const auto cells = array.empty() ? nullptr : loaded.sound_cells(array, step);
        if (!cells) continue;
        const auto is_kept = [&](ciel::Index cell) { return cell < cells->kept.size() && cells->kept[cell] != 0; };
        if (std::ranges::all_of(sound->surface.polygon_cell, is_kept)) continue;
        sound = triangles_shape(ciel::polygons_of_cells(sound->surface, cells->kept));
    }
    return sound;
}

std::string left_out_text(const std::string& scalar, bool is_cut, std::size_t step, store::LoadedDataset& loaded) {
    const auto sentence = [&](std::size_t count, const std::string& what) {
        return std::to_string(count) + (count == 1 ? " cell has " : " cells have ") + what + " at this time and " +
               (count == 1 ? "is" : "are") + " left out";
    };
    const auto dataset = loaded.dataset();
    const std::string array = store::parse_scalar(*dataset, scalar).array;
    if (const auto cells = loaded.sound_cells(scalar, step)) return sentence(cells->left_out, "no number for " + array);
    const std::size_t corners = is_cut ? loaded.cells_with_bad_corners(scalar, step) : 0;
    return corners == 0 ? std::string() : sentence(corners, "a corner without a number for " + array);
}

} // namespace server::geometry
