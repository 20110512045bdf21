#include "import/mesh/pieces.hpp"

#include "import/mesh/corner_index.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <vtkDataArray.h>
#include <vtkPointData.h>

namespace server::importer {

namespace {

bool are_equal(double a, double b) {
    return a == b || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

vtkDataArray* node_ids(const JoinedMesh::Member& piece) {
    vtkPointData* data = piece.data->GetPointData();
    vtkDataArray* ids = data->GetGlobalIds();
    if (ids == nullptr) ids = data->GetArray("GlobalNodeId");
    return ids != nullptr && ids->GetNumberOfComponents() == 1 ? ids : nullptr;
}

struct PiecePoint {
    const JoinedMesh::Member& piece;
    vtkIdType point;
};

PiecePoint point_of(const JoinedMesh::Member& piece, ciel::Index running) {
    return {piece, static_cast<vtkIdType>(running - piece.first_point)};
}

bool lie_on_each_other(const PiecePoint& a, const PiecePoint& b) {
    ciel::Vec3d p{}, q{};
    a.piece.data->GetPoint(a.point, p.data());
    b.piece.data->GetPoint(b.point, q.data());
    return p == q;
}

bool have_equal_values(const PiecePoint& a, const PiecePoint& b) {
    vtkPointData* of_a = a.piece.data->GetPointData();
    for (int i = 0; i < of_a->GetNumberOfArrays(); ++i) {
        vtkDataArray* values = of_a->GetArray(i);
        if (values == nullptr || values->GetName() == nullptr || values == of_a->GetArray("vtkGhostType")) continue;
        vtkDataArray* others = b.piece.data->GetPointData()->GetArray(values->GetName());
        if (others == nullptr || others->GetNumberOfComponents() != values->GetNumberOfComponents()) continue;
        for (int c = 0; c < values->GetNumberOfComponents(); ++c)
            if (!are_equal(values->GetComponent(a.point, c), others->GetComponent(b.point, c))) return false;
    }
    return true;
}

bool are_the_same(const PiecePoint& a, const PiecePoint& b) {
    vtkDataArray *ids_a = node_ids(a.piece), *ids_b = node_ids(b.piece);
    if (ids_a != nullptr && ids_b != nullptr)
        return are_equal(ids_a->GetComponent(a.point, 0), ids_b->GetComponent(b.point, 0));
    return lie_on_each_other(a, b) && have_equal_values(a, b);
}

std::size_t piece_of_cell(const std::vector<JoinedMesh::Member>& pieces, ciel::Index joined_cell) {
    const auto next = std::ranges::upper_bound(pieces, joined_cell, {}, &JoinedMesh::Member::mesh_cell_begin);
    return static_cast<std::size_t>(next - pieces.begin()) - 1;
}

// Sorts the pieces by first_point (joined_mesh.hpp), because pieces that share points need not be in this order.
class PiecesByPoint {
public:
    explicit PiecesByPoint(const std::vector<JoinedMesh::Member>& pieces) {
        for (const JoinedMesh::Member& piece : pieces) by_first_.emplace(piece.first_point, &piece);
    }
    [[nodiscard]] PiecePoint at(ciel::Index running) const {
        return point_of(*std::prev(by_first_.upper_bound(running))->second, running);
    }

private:
    std::map<ciel::Index, const JoinedMesh::Member*> by_first_;
};

class PieceMatcher {
public:
    PieceMatcher(const ciel::MatchedCells& cells, const JoinedMesh& joined)
        : cells_(cells), joined_(joined), boundary_(cells.boundary()), mesh_(boundary_.view()), index_(mesh_) {}

    PieceJoins run() {
        for (ciel::Index face = 0; face < mesh_.face_count(); ++face) {
            if (joined_.members[piece_of(face)].whole >= 0) add(face);
        }
        for (const auto& [corners, faces] : open_)
            for (const ciel::Index face : faces)
                if (std::ranges::any_of(faces, [&](ciel::Index other) { return are_of_one_whole(face, other); }))
                    ++cut_.apart;
        return std::move(cut_);
    }

private:
    [[nodiscard]] std::size_t piece_of(ciel::Index face) const {
        return piece_of_cell(joined_.members, cells_.original_cell()[mesh_.owner[face]]);
    }
    [[nodiscard]] bool are_of_one_whole(ciel::Index a, ciel::Index b) const {
        const std::size_t piece = piece_of(a), other = piece_of(b);
        return piece != other && joined_.members[piece].whole == joined_.members[other].whole;
    }

    void add(ciel::Index face) {
        std::vector<ciel::Index>& here = open_[index_.learn(mesh_.loop(face).unchecked())];
        const auto other = std::ranges::find_if(here, [&](ciel::Index candidate) { return join(candidate, face); });
        if (other == here.end())
            here.push_back(face);
        else
            here.erase(other);
    }

    // Returns false and joins nothing unless the faces coincide and belong to two pieces with the same `whole`.
    bool join(ciel::Index a, ciel::Index b) {
        if (!are_of_one_whole(a, b)) return false;
        const JoinedMesh::Member &piece_a = joined_.members[piece_of(a)], &piece_b = joined_.members[piece_of(b)];
        PointPairs pairs;
        for (const ciel::Index vertex : mesh_.loop(b)) {
            const PiecePoint point = point_of(piece_b, cells_.original_vertex()[vertex]);
            std::optional<ciel::Index> same;
            for (const ciel::Index candidate : mesh_.loop(a))
                if (are_the_same(point_of(piece_a, cells_.original_vertex()[candidate]), point))
                    same = cells_.original_vertex()[candidate];
            if (!same) return false;
            pairs.emplace_back(*same, cells_.original_vertex()[vertex]);
        }
        cut_.points.insert(cut_.points.end(), pairs.begin(), pairs.end());
        ++cut_.faces;
        return true;
    }

    const ciel::MatchedCells& cells_;
    const JoinedMesh& joined_;
    ciel::FaceMesh boundary_;
    ciel::FaceMeshView mesh_;
    CornerIndex index_;
    std::unordered_map<Corners, std::vector<ciel::Index>, CornersHash> open_;
    PieceJoins cut_;
};

} // namespace

PieceJoins find_cut_between_pieces(const ciel::MatchedCells& cells, const JoinedMesh& joined) {
    return PieceMatcher(cells, joined).run();
}

bool still_the_same(const PointPairs& points, const std::vector<JoinedMesh::Member>& pieces) {
    const PiecesByPoint by_point(pieces);
    return std::ranges::all_of(
        points, [&](const auto& pair) { return are_the_same(by_point.at(pair.first), by_point.at(pair.second)); });
}

} // namespace server::importer
