#include "ciel/boundary_faces.hpp"

#include <algorithm>
#include <numeric>

namespace ciel {

BoundaryFaceLists boundary_face_lists(const FaceMeshView& mesh) {
    BoundaryFaceLists lists;
    for (Index face = 0; face < mesh.face_count(); ++face) {
        if (mesh.neighbour[face] != none) continue;
        for (const Index vertex : mesh.loop(face)) lists.face_vertex.push_back(vertex);
        lists.face_offset.push_back(lists.face_vertex.size());
        lists.owner.push_back(mesh.owner[face]);
        lists.face.push_back(face);
    }
    return lists;
}

std::vector<Index> boundary_numbers(const BoundaryFaces& boundary, std::span<const Index> faces) {
    std::vector<Index> numbers;
    numbers.reserve(faces.size());
    for (const Index face : faces) {
        const auto found = std::lower_bound(boundary.face.begin(), boundary.face.end(), face);
        const bool exists = found != boundary.face.end() && *found == face;
        numbers.push_back(exists ? static_cast<Index>(found - boundary.face.begin()) : none);
    }
    return numbers;
}

std::vector<Index> boundary_numbers(const FaceMeshView& mesh, std::span<const Index> faces) {
    std::vector<std::size_t> order(faces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return faces[i]; });
    std::vector<Index> numbers(faces.size(), none);
    Index number = 0;
    auto next = order.begin();
    for (Index face = 0; face < mesh.face_count(); ++face) {
        const bool is_boundary = mesh.neighbour[face] == none;
        for (; next != order.end() && faces[*next] == face; ++next)
            if (is_boundary) numbers[*next] = number;
        if (is_boundary) ++number;
    }
    return numbers;
}

} // namespace ciel
