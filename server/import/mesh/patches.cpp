#include "import/mesh/patches.hpp"

#include "import/mesh/corner_index.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <vtkPointSet.h>

namespace server::importer {

namespace {

// The two sides of a baffle have the same corners. claim() returns the side that fewer surfaces have claimed.
class BoundaryFaces {
public:
    void add(Corners corners, ciel::Index face) { faces_[std::move(corners)].push_back({face, 0, ciel::none}); }

    ciel::Index claim(const Corners& corners, ciel::Index surface) {
        const auto found = faces_.find(corners);
        if (found == faces_.end()) return ciel::none;
        Candidate* best = nullptr;
        for (Candidate& candidate : found->second)
            if (candidate.last_surface != surface && (best == nullptr || candidate.claims < best->claims))
                best = &candidate;
        if (best == nullptr) return ciel::none;
        best->last_surface = surface;
        ++best->claims;
        return best->face;
    }

private:
    struct Candidate {
        ciel::Index face;
        ciel::Index claims;
        ciel::Index last_surface;
    };
    std::unordered_map<Corners, std::vector<Candidate>, CornersHash> faces_;
};

template <typename Corner>
void add_boundary(const ciel::FaceMeshView& mesh, BoundaryFaces& faces, Corner&& corners_of) {
    for (ciel::Index face = 0; face < mesh.face_count(); ++face)
        if (mesh.neighbour[face] == ciel::none) faces.add(corners_of(mesh.loop(face).unchecked()), face);
}

class ByPlace {
public:
    explicit ByPlace(const ciel::FaceMeshView& mesh) : index_(mesh) {
        add_boundary(mesh, faces_, [this](std::span<const ciel::Index> loop) { return index_.learn(loop); });
    }
    ciel::Index claim(vtkDataSet* data, vtkIdType cell, ciel::Index surface) {
        return faces_.claim(index_.find(data, cell), surface);
    }

private:
    CornerIndex index_;
    BoundaryFaces faces_;
};

// Matches surfaces by point ids. A welded point is replaced by its representative (Welds::representative).
class ById {
public:
    ById(const ciel::FaceMeshView& boundary, std::span<const ciel::Index> point_of_vertex, const JoinedMesh& joined,
         const std::vector<ciel::Index>& representative)
        : representative_(representative), stored_(joined.point_count, ciel::none) {
        for (ciel::Index vertex = 0; vertex < point_of_vertex.size(); ++vertex)
            stored_[point_of_vertex[vertex]] = vertex;
        add_boundary(boundary, faces_, [](std::span<const ciel::Index> loop) {
            return normalised({loop.begin(), loop.end()});
        });
    }
    ciel::Index claim(vtkDataSet* data, vtkIdType cell, ciel::Index first_point, ciel::Index surface) {
        data->GetCellPoints(cell, ids_);
        Corners corners;
        for (vtkIdType i = 0; i < ids_->GetNumberOfIds(); ++i) {
            const ciel::Index running = first_point + static_cast<ciel::Index>(ids_->GetId(i));
            corners.push_back(stored_[representative_.empty() ? running : representative_[running]]);
        }
        return faces_.claim(normalised(std::move(corners)), surface);
    }

private:
    const std::vector<ciel::Index>& representative_;
    std::vector<ciel::Index> stored_; // running point -> stored vertex, or `none`
    BoundaryFaces faces_;
    vtkNew<vtkIdList> ids_;
};

class Matcher {
public:
    Matcher(const ciel::FaceMeshView& boundary, std::span<const ciel::Index> point_of_vertex, const JoinedMesh& joined,
            const std::vector<ciel::Index>& representative)
        : boundary_(boundary), point_of_vertex_(point_of_vertex), joined_(joined), representative_(representative) {}

    void add(Patch patch, vtkDataSet* data, std::span<const vtkIdType> cells) {
        const JoinedMesh::Member* member = member_with_points_of(data);
        const auto surface = static_cast<ciel::Index>(patches_.size());
        for (const vtkIdType cell : cells) {
            const ciel::Index face = member != nullptr ? by_id().claim(data, cell, member->first_point, surface)
                                                       : by_place().claim(data, cell, surface);
            if (face == ciel::none) {
                ++patch.unmatched;
                continue;
            }
            patch.faces.push_back(face);
            patch.cells.push_back(static_cast<std::size_t>(cell));
        }
        patches_.push_back(std::move(patch));
    }

    std::vector<Patch> take() { return std::move(patches_); }

private:
    [[nodiscard]] const JoinedMesh::Member* member_with_points_of(vtkDataSet* data) const {
        auto* set = vtkPointSet::SafeDownCast(data);
        if (set == nullptr || set->GetPoints() == nullptr) return nullptr;
        const auto found =
            std::find_if(joined_.members.begin(), joined_.members.end(), [&](const JoinedMesh::Member& member) {
                auto* own = vtkPointSet::SafeDownCast(member.data);
                return own != nullptr && own->GetPoints() == set->GetPoints();
            });
        return found == joined_.members.end() ? nullptr : &*found;
    }
    ByPlace& by_place() {
        if (!by_place_) by_place_.emplace(boundary_);
        return *by_place_;
    }
    ById& by_id() {
        if (!by_id_) by_id_.emplace(boundary_, point_of_vertex_, joined_, representative_);
        return *by_id_;
    }

    const ciel::FaceMeshView boundary_;
    std::span<const ciel::Index> point_of_vertex_;
    const JoinedMesh& joined_;
    const std::vector<ciel::Index>& representative_;
    std::optional<ByPlace> by_place_;
    std::optional<ById> by_id_;
    std::vector<Patch> patches_;
};

} // namespace

std::vector<Patch> match_patches(const ciel::FaceMeshView& boundary, std::span<const ciel::Index> point_of_vertex,
                                 const JoinedMesh& joined, const std::vector<ciel::Index>& representative,
                                 const std::vector<InputGrid>& surfaces) {
    Matcher matcher(boundary, point_of_vertex, joined, representative);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        std::vector<vtkIdType> cells(static_cast<std::size_t>(surfaces[i].data->GetNumberOfCells()));
        std::iota(cells.begin(), cells.end(), vtkIdType{0});
        const std::size_t source = surfaces[i].own_values ? i : Patch::none_of_them;
        matcher.add({surfaces[i].name, source, {}, {}, 0}, surfaces[i].data, cells);
    }
    for (const JoinedMesh::FlatCells& flat : joined.flat_cells) {
        const JoinedMesh::Member& member = joined.members[flat.member];
        matcher.add({member.name + " surface", Patch::none_of_them, {}, {}, 0}, member.data, flat.cells);
    }
    return matcher.take();
}

} // namespace server::importer
