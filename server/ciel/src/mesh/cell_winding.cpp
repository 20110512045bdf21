#include "mesh/cell_winding.hpp"

#include "mesh/loop.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace ciel::detail {

using Reason = BadCells::Reason;

CellWinding::CellWinding(const InputFaces& input) : input_(input), local_of_(input.vertex_count(), none) {}

bool CellWinding::gather(Index cell) {
    faces_.clear();
    from_.clear();
    face_of_.clear();
    vertices_.clear();
    InputFaces::Corners corners;
    for (Index f = input_.begin(cell); f < input_.end(cell); ++f) {
        const std::span<const Index> loop = input_.loop(cell, f, corners);
        if (loop.size() < 3) continue;
        if (std::ranges::any_of(loop, [&](Index v) { return v >= local_of_.size(); })) return false;
        loop_.clear();
        append_without_repeats(loop, loop_);
        const auto begin = static_cast<Index>(from_.size());
        for (const Index v : loop_) {
            if (local_of_[v] == none) {
                local_of_[v] = static_cast<Index>(vertices_.size());
                vertices_.push_back(v);
            }
            from_.push_back(local_of_[v]);
            face_of_.push_back(static_cast<Index>(faces_.size()));
        }
        faces_.push_back({f, begin, static_cast<Index>(from_.size())});
    }
    return true;
}

void CellWinding::forget() {
    for (const Index v : vertices_) local_of_[v] = none;
}

Index CellWinding::target(Index half_edge) const {
    const Face& face = faces_[face_of_[half_edge]];
    return from_[half_edge + 1 == face.end ? face.begin : half_edge + 1];
}

// Returns true when each pair of vertices has as many half-edges a -> b as b -> a.
bool CellWinding::balanced() {
    constexpr Index most_listed = 1024;
    const auto count = static_cast<Index>(from_.size());
    if (count > most_listed) return balanced_when_sorted(); // avoids quadratic time at a vertex with many half-edges
    head_.assign(vertices_.size(), none);
    next_.resize(count);
    paired_.assign(count, 0);
    Index open = 0;
    for (Index h = 0; h < count; ++h) {
        const Index a = faces_[face_of_[h]].turned ? target(h) : from_[h];
        const Index b = faces_[face_of_[h]].turned ? from_[h] : target(h);
        Index mate = head_[b];
        while (mate != none && (paired_[mate] || (faces_[face_of_[mate]].turned ? from_[mate] : target(mate)) != a))
            mate = next_[mate];
        if (mate != none) {
            paired_[mate] = paired_[h] = 1;
            --open;
        } else {
            ++open;
        }
        next_[h] = head_[a];
        head_[a] = h;
    }
    return open == 0;
}

bool CellWinding::balanced_when_sorted() {
    uses_.clear();
    for (Index h = 0; h < from_.size(); ++h) {
        const Index a = from_[h], b = target(h);
        uses_.push_back({std::min(a, b), std::max(a, b), face_of_[h], (a < b) != faces_[face_of_[h]].turned});
    }
    std::ranges::sort(uses_, {}, [](const Use& use) { return std::pair(use.low, use.high); });
    std::int64_t balance = 0; // of one edge (low, high): half-edges low -> high minus half-edges high -> low
    for (std::size_t i = 0; i < uses_.size(); ++i) {
        balance += uses_[i].upward ? 1 : -1;
        const bool last =
            i + 1 == uses_.size() || uses_[i + 1].low != uses_[i].low || uses_[i + 1].high != uses_[i].high;
        if (last && balance != 0) return false;
    }
    return true;
}

// Returns false when an edge has an odd number of half-edges, which means that the cell is open.
bool CellWinding::collect_edges() {
    uses_.clear();
    for (Index h = 0; h < from_.size(); ++h) {
        const Index a = from_[h], b = target(h);
        uses_.push_back({std::min(a, b), std::max(a, b), face_of_[h], a < b});
    }
    std::ranges::sort(uses_, [](const Use& x, const Use& y) {
        return std::tie(x.low, x.high, x.face, x.upward) < std::tie(y.low, y.high, y.face, y.upward);
    });
    neighbours_.assign(faces_.size(), {});
    for (std::size_t begin = 0, end; begin < uses_.size(); begin = end) {
        std::vector<Use> edge; // half-edges of one edge, without opposite pairs of a collapsed face
        for (end = begin;
             end < uses_.size() && uses_[end].low == uses_[begin].low && uses_[end].high == uses_[begin].high; ++end) {
            if (!edge.empty() && edge.back().face == uses_[end].face && edge.back().upward != uses_[end].upward)
                edge.pop_back();
            else
                edge.push_back(uses_[end]);
        }
        if (edge.size() % 2 != 0) return false;
        if (edge.size() != 2 || edge[0].face == edge[1].face) continue;
        const bool same = edge[0].upward == edge[1].upward;
        neighbours_[edge[0].face].push_back({edge[1].face, same});
        neighbours_[edge[1].face].push_back({edge[0].face, same});
    }
    return true;
}

// Makes the faces of each lobe agree with the winding of its first face. Returns the number of lobes.
Index CellWinding::spread_winding() {
    lobe_.assign(faces_.size(), none);
    std::vector<Index> queue;
    Index lobes = 0;
    for (Index start = 0; start < faces_.size(); ++start) {
        if (lobe_[start] != none) continue;
        lobe_[start] = lobes;
        queue.assign(1, start);
        while (!queue.empty()) {
            const Index face = queue.back();
            queue.pop_back();
            for (const Neighbour& other : neighbours_[face]) {
                if (lobe_[other.face] != none) continue;
                lobe_[other.face] = lobes;
                faces_[other.face].turned = faces_[face].turned != other.same_direction;
                queue.push_back(other.face);
            }
        }
        ++lobes;
    }
    return lobes;
}

std::vector<Index> CellWinding::lobes(Index cell) {
    std::vector<Index> out(input_.end(cell) - input_.begin(cell), 0);
    if (gather(cell) && collect_edges()) {
        const Index count = spread_winding();
        if (count > 1) {
            join_open_lobes(count);
            for (Index face = 0; face < faces_.size(); ++face)
                out[faces_[face].id - input_.begin(cell)] = joined(lobe_[face]);
        }
    }
    forget();
    return out;
}

// Joins lobes that are closed only together: several lobes may meet at an edge at which each of them is open. Visits
// the edges one after another, because lobes that were joined at an earlier edge may be closed at a later edge.
void CellWinding::join_open_lobes(Index count) {
    joined_to_.resize(count);
    std::iota(joined_to_.begin(), joined_to_.end(), Index{0});
    std::vector<std::int64_t> balance(count, 0); // by lobe, at one edge: half-edges low -> high minus high -> low
    for (std::size_t begin = 0, end; begin < uses_.size(); begin = end) {
        for (end = begin;
             end < uses_.size() && uses_[end].low == uses_[begin].low && uses_[end].high == uses_[begin].high; ++end)
            balance[lobe_at(uses_[end])] += uses_[end].upward != faces_[uses_[end].face].turned ? 1 : -1;
        const std::span edge = std::span(uses_).subspan(begin, end - begin);
        const auto open = std::ranges::find_if(edge, [&](const Use& use) { return balance[lobe_at(use)] != 0; });
        for (const Use& use : edge) balance[lobe_at(use)] = 0;
        if (open == edge.end()) continue;
        const Index lobe = lobe_at(*open);
        for (const Use& use : edge) joined_to_[lobe_at(use)] = lobe;
    }
}

// Union-find with path halving.
Index CellWinding::joined(Index lobe) {
    for (; joined_to_[lobe] != lobe; lobe = joined_to_[lobe]) joined_to_[lobe] = joined_to_[joined_to_[lobe]];
    return lobe;
}

std::optional<Reason> CellWinding::make_agree() {
    if (balanced()) return std::nullopt;
    if (!collect_edges()) return Reason::open;
    spread_winding();
    return balanced() ? std::nullopt : std::optional(Reason::inconsistent_winding);
}

Vec3d CellWinding::position(Index local) const {
    const std::size_t at = 3 * std::size_t{vertices_[local]};
    const ValuesView& positions = input_.input().positions;
    return {positions[at], positions[at + 1], positions[at + 2]};
}

Vec3d CellWinding::center() const {
    Vec3d sum{};
    for (Index local = 0; local < vertices_.size(); ++local) {
        const Vec3d p = position(local);
        for (std::size_t i = 0; i < 3; ++i) sum[i] += p[i];
    }
    for (double& x : sum) x /= static_cast<double>(std::max<std::size_t>(1, vertices_.size()));
    return sum;
}

double CellWinding::signed_volume(const Vec3d& center) const {
    const auto arm = [&](Index half_edge) {
        const Vec3d p = position(from_[half_edge]);
        return Vec3d{p[0] - center[0], p[1] - center[1], p[2] - center[2]};
    };
    double six_volumes = 0;
    for (const Face& face : faces_) {
        double six_cones = 0;
        if (face.end - face.begin < 3) continue;
        const Vec3d a = arm(face.begin);
        Vec3d b = arm(face.begin + 1);
        for (Index h = face.begin + 2; h < face.end; ++h) {
            const Vec3d c = arm(h);
            six_cones += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                         a[2] * (b[0] * c[1] - b[1] * c[0]);
            b = c;
        }
        six_volumes += face.turned ? -six_cones : six_cones;
    }
    return six_volumes / 6;
}

CellWinding::Verdict CellWinding::judge(Index cell, std::span<std::uint8_t> turn) {
    Verdict verdict;
    if (!gather(cell)) {
        verdict.bad = Reason::index_out_of_range;
    } else if (faces_.size() < 4) {
        verdict.bad = Reason::too_few_faces;
    } else {
        verdict.bad = make_agree();
        verdict.center = center();
        verdict.volume = signed_volume(verdict.center);
        if (!verdict.bad && !std::isfinite(verdict.volume)) verdict.bad = Reason::inside_out_unresolved;
    }
    forget();
    const bool inward = verdict.volume < 0;
    verdict.volume = std::abs(verdict.volume);
    for (const Face& face : faces_) turn[face.id] = face.turned != inward ? 1 : 0;
    return verdict;
}

} // namespace ciel::detail
