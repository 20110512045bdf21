#include "import/mesh/welds.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <vtkStructuredGrid.h>

namespace server::importer {

namespace {

// Tolerance as a share of the diagonal of the member's bounding box. Rounding in a file makes smaller differences.
constexpr double position_tolerance = 1e-6;

class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), ciel::Index{0});
    }
    ciel::Index find(ciel::Index i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(ciel::Index a, ciel::Index b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b); // the smallest id represents the set
    }
    std::vector<ciel::Index> representatives() {
        for (ciel::Index i = 0; i < parent_.size(); ++i) find(i);
        for (ciel::Index i = 0; i < parent_.size(); ++i) parent_[i] = find(i);
        return std::move(parent_);
    }

private:
    std::vector<ciel::Index> parent_;
};

class SeamFinder {
public:
    SeamFinder(const JoinedMesh& mesh, std::size_t member, vtkStructuredGrid* grid) : mesh_(mesh), member_(member) {
        grid->GetDimensions(dims_.data());
        double bounds[6];
        grid->GetBounds(bounds);
        const double diagonal = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
        tolerance_ = position_tolerance * diagonal;
    }

    std::vector<Seam> find() const {
        std::vector<Seam> seams;
        const auto add = [&](PointPairs points) {
            if (!points.empty()) seams.push_back({member_, std::move(points), tolerance_});
        };
        for (int axis = 0; axis < 3; ++axis) {
            if (dims_[axis] < 3) continue;
            add(opposite_faces(axis));
            for (const int plane : {0, dims_[axis] - 1})
                for (const int fold : {(axis + 1) % 3, (axis + 2) % 3}) add(folded_face(axis, plane, fold));
        }
        return seams;
    }

private:
    [[nodiscard]] ciel::Index point(std::array<int, 3> ijk) const {
        return mesh_.members[member_].first_point +
               static_cast<ciel::Index>(ijk[0] + dims_[0] * (ijk[1] + static_cast<std::int64_t>(dims_[1]) * ijk[2]));
    }
    [[nodiscard]] bool coincide(ciel::Index a, ciel::Index b) const {
        double distance = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            distance = std::max(distance, std::abs(mesh_.positions[3 * std::size_t{a} + axis] -
                                                   mesh_.positions[3 * std::size_t{b} + axis]));
        return distance <= tolerance_;
    }

    [[nodiscard]] PointPairs opposite_faces(int axis) const {
        PointPairs pairs;
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        for (int i = 0; i < dims_[u]; ++i)
            for (int j = 0; j < dims_[v]; ++j) {
                std::array<int, 3> ijk{};
                ijk[u] = i;
                ijk[v] = j;
                const ciel::Index first = point(ijk);
                ijk[axis] = dims_[axis] - 1;
                pairs.emplace_back(first, point(ijk));
                if (!coincide(pairs.back().first, pairs.back().second)) return {};
            }
        return pairs;
    }

    // Returns the point pairs of the wake cut of a C-grid. If the axis `fold` has n points, the points i and n - 1 - i
    // coincide. Returns no pairs for a face that is collapsed to a line or a point (a polar axis).
    [[nodiscard]] PointPairs folded_face(int axis, int plane, int fold) const {
        const int along = 3 - axis - fold;
        PointPairs pairs;
        int columns = 0;
        for (; columns < dims_[fold] / 2; ++columns) {
            PointPairs column;
            bool collapsed = true;
            for (int k = 0; k < dims_[along]; ++k) {
                std::array<int, 3> ijk{};
                ijk[axis] = plane;
                ijk[along] = k;
                const auto at = [&](int i) {
                    ijk[fold] = i;
                    return point(ijk);
                };
                column.emplace_back(at(columns), at(dims_[fold] - 1 - columns));
                if (!coincide(column.back().first, column.back().second)) return columns < 2 ? PointPairs{} : pairs;
                collapsed = collapsed && coincide(at(columns), at(columns + 1));
            }
            if (collapsed) return {};
            pairs.insert(pairs.end(), column.begin(), column.end());
        }
        return columns < 2 ? PointPairs{} : pairs;
    }

    const JoinedMesh& mesh_;
    std::size_t member_;
    std::array<int, 3> dims_{};
    double tolerance_ = 0;
};

std::string count_text(std::uint64_t count, const char* what) { return std::to_string(count) + " " + what; }

void weld_seams(const JoinedMesh& mesh, const SeamDifference& difference_across, DisjointSets& sets, Welds& welds) {
    for (std::size_t i = 0; i < mesh.members.size(); ++i) {
        const JoinedMesh::Member& member = mesh.members[i];
        auto* grid = vtkStructuredGrid::SafeDownCast(member.data);
        if (grid == nullptr) continue;
        std::string name;
        if (!member.name.empty()) name.append(" (\"").append(member.name).append("\")");
        for (Seam& seam : SeamFinder(mesh, i, grid).find()) {
            const std::string difference = difference_across({seam}, mesh.members);
            if (!difference.empty()) {
                std::string sentence = "A structured block" + name + " closes onto itself, but ";
                sentence.append(difference).append(" differs across the seam, so the seam was not welded.");
                welds.notes.push_back(std::move(sentence));
                continue;
            }
            for (const auto& [a, b] : seam.points) sets.join(a, b);
            welds.notes.push_back("The seam of a structured block" + name + ", closed onto itself, was welded: " +
                                  count_text(seam.points.size(), "pairs of points."));
            welds.seams.push_back(std::move(seam));
        }
    }
}

void join_cut(const PieceJoins& cut, DisjointSets& sets, Welds& welds) {
    for (const auto& [a, b] : cut.points) sets.join(a, b);
    if (cut.faces > 0)
        welds.notes.push_back("The pieces of the mesh were joined along " + count_text(cut.faces, "faces."));
    if (cut.apart > 0)
        welds.notes.push_back(
            count_text(cut.apart, "faces of pieces") +
            " coincide with faces of another piece but differ in ids or values, and stay boundary faces.");
    if (cut.single > 0)
        welds.notes.push_back(count_text(cut.single, "faces of no patch") +
                              " have no counterpart on another piece and stay boundary faces.");
}

ciel::Vec3d middle_of(const JoinedMesh& mesh, const std::vector<bool>& looked_at) {
    ciel::Vec3d middle{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (std::size_t i = 0; i < looked_at.size(); ++i) {
            if (!looked_at[i]) continue;
            low = std::min(low, mesh.positions[3 * i + axis]);
            high = std::max(high, mesh.positions[3 * i + axis]);
        }
        if (low <= high) middle[axis] = low / 2 + high / 2;
    }
    return middle;
}

// Compares floats relative to the center of the mesh, because programs round the copies of a point differently.
template <typename Visit>
void for_each_coincident(const JoinedMesh& mesh, const std::vector<bool>& looked_at, Visit&& visit) {
    struct Hash {
        std::size_t operator()(const std::array<float, 3>& p) const {
            std::uint64_t hash = 0;
            for (const float x : p) hash = (hash ^ std::bit_cast<std::uint32_t>(x)) * 0x9E3779B97F4A7C15U;
            return hash ^ (hash >> 32);
        }
    };
    std::unordered_map<std::array<float, 3>, ciel::Index, Hash> first;
    first.reserve(mesh.point_count);
    const ciel::Vec3d middle = middle_of(mesh, looked_at);
    const auto offset = [&](ciel::Index point, std::size_t axis) {
        return static_cast<float>(mesh.positions[3 * std::size_t{point} + axis] - middle[axis]) + 0.0F; // -0 becomes +0
    };
    for (ciel::Index i = 0; i < mesh.point_count; ++i) {
        if (!looked_at[i]) continue;
        const auto [at, is_new] = first.try_emplace({offset(i, 0), offset(i, 1), offset(i, 2)}, i);
        if (!is_new) visit(at->second, i);
    }
}

} // namespace

Welds find_welds(const JoinedMesh& mesh, Weld mode, const PieceJoins& cut, const SeamDifference& difference) {
    Welds welds;
    DisjointSets sets(mesh.point_count);
    join_cut(cut, sets, welds);
    if (mode == Weld::seams) weld_seams(mesh, difference, sets, welds);
    std::uint64_t coincident = 0;
    const bool look = mode == Weld::all || mesh.members.size() > 1;
    // Points without cells belong to ghost cells, which were left out. Only --weld also compares these points.
    std::vector<bool> looked_at(look ? mesh.point_count : 0, mode == Weld::all);
    if (look) JoinedMesh::for_vertices(mesh, [&](ciel::Index point) { looked_at[point] = true; });
    if (look)
        for_each_coincident(mesh, looked_at, [&](ciel::Index a, ciel::Index b) {
            coincident += sets.find(a) == sets.find(b) ? 0 : 1; // 0 if a cut or a seam joined the pair
            if (mode == Weld::all) sets.join(a, b);
        });
    std::vector<ciel::Index> representative = sets.representatives();
    for (ciel::Index i = 0; i < mesh.point_count; ++i) welds.welded_points += representative[i] != i ? 1 : 0;
    if (mode == Weld::all)
        welds.notes.push_back(
            count_text(welds.welded_points, "points that coincide with others were welded (--weld)."));
    else if (coincident > 0)
        welds.notes.push_back(
            count_text(coincident, "points coincide with others and were not welded; --weld welds them."));
    if (welds.welded_points > 0) welds.representative = std::move(representative);
    return welds;
}

} // namespace server::importer
