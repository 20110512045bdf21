#include "import/mesh/pieces.hpp"

#include "import/mesh/corner_index.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <vtkDataArray.h>
#include <vtkPointData.h>

namespace ciel::importer {

namespace {

bool are_equal(double a, double b) {
    return a == b || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

vtkDataArray* node_ids(const JoinedMesh::Member& part) {
    vtkPointData* data = part.data->GetPointData();
    vtkDataArray* ids = data->GetGlobalIds();
    if (ids == nullptr) ids = data->GetArray("GlobalNodeId");
    return ids != nullptr && ids->GetNumberOfComponents() == 1 ? ids : nullptr;
}

struct PartPoint {
    const JoinedMesh::Member& part;
    vtkIdType point;
};

PartPoint point_of(const JoinedMesh::Member& part, Index running) {
    return {part, static_cast<vtkIdType>(running - part.first_point)};
}

bool lie_on_each_other(const PartPoint& a, const PartPoint& b) {
    Vec3d p{}, q{};
    a.part.data->GetPoint(a.point, p.data());
    b.part.data->GetPoint(b.point, q.data());
    return p == q;
}

bool have_equal_values(const PartPoint& a, const PartPoint& b) {
    vtkPointData* of_a = a.part.data->GetPointData();
    for (int i = 0; i < of_a->GetNumberOfArrays(); ++i) {
        vtkDataArray* values = of_a->GetArray(i);
        if (values == nullptr || values->GetName() == nullptr || values == of_a->GetArray("vtkGhostType")) continue;
        vtkDataArray* others = b.part.data->GetPointData()->GetArray(values->GetName());
        if (others == nullptr || others->GetNumberOfComponents() != values->GetNumberOfComponents()) continue;
        for (int c = 0; c < values->GetNumberOfComponents(); ++c)
            if (!are_equal(values->GetComponent(a.point, c), others->GetComponent(b.point, c))) return false;
    }
    return true;
}

bool are_the_same(const PartPoint& a, const PartPoint& b) {
    vtkDataArray *ids_a = node_ids(a.part), *ids_b = node_ids(b.part);
    if (ids_a != nullptr && ids_b != nullptr)
        return are_equal(ids_a->GetComponent(a.point, 0), ids_b->GetComponent(b.point, 0));
    return lie_on_each_other(a, b) && have_equal_values(a, b);
}

std::size_t part_of_cell(const std::vector<JoinedMesh::Member>& parts, Index joined_cell) {
    const auto next = std::ranges::upper_bound(parts, joined_cell, {}, &JoinedMesh::Member::mesh_cell_begin);
    return static_cast<std::size_t>(next - parts.begin()) - 1;
}

// Sorts the parts by first_point, because parts that share points can be in another order.
class PartsByPoint {
public:
    explicit PartsByPoint(const std::vector<JoinedMesh::Member>& parts) {
        for (const JoinedMesh::Member& part : parts) by_first_.emplace(part.first_point, &part);
    }
    [[nodiscard]] PartPoint at(Index running) const {
        return point_of(*std::prev(by_first_.upper_bound(running))->second, running);
    }

private:
    std::map<Index, const JoinedMesh::Member*> by_first_;
};

class PartMatcher {
public:
    PartMatcher(const Assembled& pieces, const JoinedMesh& joined)
        : pieces_(pieces), joined_(joined), mesh_(pieces.mesh.view()), index_(mesh_) {}

    PieceJoins run() {
        for (Index face = 0; face < mesh_.face_count(); ++face) {
            if (mesh_.neighbour[face] == none && joined_.parts[part_of(face)].whole >= 0) add(face);
        }
        for (const auto& [corners, faces] : open_)
            for (const Index face : faces)
                if (std::ranges::any_of(faces, [&](Index other) { return are_of_one_whole(face, other); }))
                    ++cut_.apart;
        return std::move(cut_);
    }

private:
    [[nodiscard]] std::size_t part_of(Index face) const {
        return part_of_cell(joined_.parts, pieces_.original_cell[mesh_.owner[face]]);
    }
    [[nodiscard]] bool are_of_one_whole(Index a, Index b) const {
        const std::size_t part = part_of(a), other = part_of(b);
        return part != other && joined_.parts[part].whole == joined_.parts[other].whole;
    }

    void add(Index face) {
        std::vector<Index>& here = open_[index_.learn(mesh_.loop(face).unchecked())];
        const auto other = std::ranges::find_if(here, [&](Index candidate) { return join(candidate, face); });
        if (other == here.end())
            here.push_back(face);
        else
            here.erase(other);
    }

    // Returns false and joins nothing unless the faces coincide and belong to two parts with the same `whole`.
    bool join(Index a, Index b) {
        if (!are_of_one_whole(a, b)) return false;
        const JoinedMesh::Member &part_a = joined_.parts[part_of(a)], &part_b = joined_.parts[part_of(b)];
        PointPairs pairs;
        for (const Index vertex : mesh_.loop(b)) {
            const PartPoint point = point_of(part_b, pieces_.original_vertex[vertex]);
            std::optional<Index> same;
            for (const Index candidate : mesh_.loop(a))
                if (are_the_same(point_of(part_a, pieces_.original_vertex[candidate]), point))
                    same = pieces_.original_vertex[candidate];
            if (!same) return false;
            pairs.emplace_back(*same, pieces_.original_vertex[vertex]);
        }
        cut_.points.insert(cut_.points.end(), pairs.begin(), pairs.end());
        ++cut_.faces;
        return true;
    }

    const Assembled& pieces_;
    const JoinedMesh& joined_;
    FaceMeshView mesh_;
    CornerIndex index_;
    std::unordered_map<Corners, std::vector<Index>, CornersHash> open_;
    PieceJoins cut_;
};

} // namespace

PieceJoins find_cut_between_parts(const Assembled& pieces, const JoinedMesh& joined) {
    return PartMatcher(pieces, joined).run();
}

bool still_the_same(const PointPairs& points, const std::vector<JoinedMesh::Member>& parts) {
    const PartsByPoint by_point(parts);
    return std::ranges::all_of(
        points, [&](const auto& pair) { return are_the_same(by_point.at(pair.first), by_point.at(pair.second)); });
}

} // namespace ciel::importer
