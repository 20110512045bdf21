#include "store/group_faces.hpp"

#include <algorithm>

namespace ciel::store {

GroupFaces faces_of(const Group& group, const Dataset& dataset, const Step& step) {
    std::vector<Index> ids(group.ids.begin(), group.ids.end());
    const BoundaryFaces boundary = dataset.boundary(step.mesh, step.coordinates);
    std::vector<Index> numbers = boundary_numbers(boundary, ids);
    if (std::ranges::find(numbers, none) == numbers.end()) return {boundary.mesh, std::move(numbers)};
    return {dataset.mesh(step.mesh, step.coordinates), std::move(ids)};
}

} // namespace ciel::store
