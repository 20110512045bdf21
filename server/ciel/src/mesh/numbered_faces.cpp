#include "ciel/numbered_faces.hpp"

#include <algorithm>
#include <numeric>

namespace ciel {

namespace {

void add_face(const FaceMeshView& mesh, Index face, FaceLists& lists) {
    for (const Index vertex : mesh.loop(face)) lists.face_vertex.push_back(vertex);
    lists.face_offset.push_back(lists.face_vertex.size());
    lists.owner.push_back(mesh.owner[face]);
    lists.neighbour.push_back(mesh.neighbour[face]);
}

} // namespace

FaceLists numbered_faces(const FaceMeshView& mesh, std::span<const Index> inner) {
    FaceLists lists;
    for (Index face = 0; face < mesh.face_count(); ++face)
        if (mesh.neighbour[face] == none) add_face(mesh, face, lists);
    for (const Index face : inner) add_face(mesh, face, lists);
    return lists;
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

FaceMeshView with_faces(FaceMeshView points, std::shared_ptr<const FaceLists> faces) {
    using Owners = std::pair<std::shared_ptr<const void>, std::shared_ptr<const FaceLists>>;
    points.face_offset = {faces->face_offset, faces->face_vertex.size() + 1};
    points.face_vertex = {faces->face_vertex, points.vertex_count()};
    points.owner = {faces->owner, points.cell_count()};
    points.neighbour = {faces->neighbour, points.cell_count()};
    points.keep_alive = std::make_shared<const Owners>(points.owned().keep_alive, std::move(faces));
    return points;
}

} // namespace ciel
