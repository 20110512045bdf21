#include "ciel/face_lists.hpp"

#include "mesh/standard_shapes.hpp"

#include <algorithm>

namespace ciel {

using detail::StandardShape;
using detail::type_of_faces;
using detail::with_shape;

void append_prism_faces(std::span<const Index> corners, std::vector<std::uint64_t>& face_offset,
                        std::vector<Index>& face_vertex) {
    const std::size_t n = corners.size() / 2;
    const auto close = [&] { face_offset.push_back(face_vertex.size()); };
    for (std::size_t i = n; i-- > 0;) face_vertex.push_back(corners[i]);
    close();
    for (std::size_t i = 0; i < n; ++i) face_vertex.push_back(corners[n + i]);
    close();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        for (const std::size_t corner : {i, j, n + j, n + i}) face_vertex.push_back(corners[corner]);
        close();
    }
}

CellType type_of_cell(std::span<const std::uint64_t> face_offset, std::span<const Index> face_vertex) {
    std::size_t largest = 0;
    for (std::size_t face = 0; face + 1 < face_offset.size(); ++face)
        largest = std::max<std::size_t>(largest, face_offset[face + 1] - face_offset[face]);
    const std::span<const Index> loops =
        face_vertex.subspan(face_offset.front(), face_offset.back() - face_offset.front());
    const CellType type = type_of_faces(face_offset.size() - 1, loops.size(), largest);
    std::size_t corners = 0;
    if (!with_shape(type, [&corners]<const StandardShape & shape>() { corners = shape.corners; })) return type;
    std::array<Index, 24> ids{}; // a hexahedron, the largest standard cell, has 24 half-edges
    const auto last = std::ranges::copy(loops, ids.begin()).out;
    std::sort(ids.begin(), last);
    const auto distinct = static_cast<std::size_t>(std::unique(ids.begin(), last) - ids.begin());
    return distinct == corners ? type : CellType::polyhedron;
}

} // namespace ciel
