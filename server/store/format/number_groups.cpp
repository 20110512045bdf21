#include "store/format/number_groups.hpp"

#include <algorithm>

namespace server::store {
namespace {

void sort_once(std::vector<ciel::Index>& ids) {
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

} // namespace

NumberedGroups number_groups(const ciel::FaceMeshView& mesh, std::span<const std::vector<ciel::Index>> groups) {
    std::vector<ciel::Index> all, inner;
    for (const std::vector<ciel::Index>& ids : groups) all.insert(all.end(), ids.begin(), ids.end());
    sort_once(all);
    if (!all.empty() && all.back() >= mesh.face_count())
        throw ciel::Error("a group contains face " + std::to_string(all.back()) + ", but the mesh has only " +
                          std::to_string(mesh.face_count()) + " faces");
    const std::vector<ciel::Index> on_boundary = ciel::boundary_numbers(mesh, all);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (on_boundary[i] == ciel::none) inner.push_back(all[i]);
    NumberedGroups numbered{ciel::numbered_faces(mesh, inner), {}};
    const std::size_t boundary = numbered.faces.owner.size() - inner.size();
    for (std::vector<ciel::Index> ids : groups) {
        for (ciel::Index& id : ids) {
            const auto place = std::ranges::lower_bound(all, id) - all.begin();
            const ciel::Index number = on_boundary[static_cast<std::size_t>(place)];
            const auto among_inner = static_cast<std::size_t>(std::ranges::lower_bound(inner, id) - inner.begin());
            id = number != ciel::none ? number : static_cast<ciel::Index>(boundary + among_inner);
        }
        sort_once(ids);
        numbered.ids.push_back(std::move(ids));
    }
    return numbered;
}

} // namespace server::store
