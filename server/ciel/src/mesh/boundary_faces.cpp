#include "ciel/boundary_faces.hpp"

#include <algorithm>
#include <numeric>

namespace ciel {

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
