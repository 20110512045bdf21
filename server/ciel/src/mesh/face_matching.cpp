#include "mesh/face_matching.hpp"

#include "ciel/parallel.hpp"
#include "ciel/threads.hpp"
#include "mesh/cell_winding.hpp"
#include "mesh/loop.hpp"
#include "mesh/repeated_cells.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ciel::detail {

namespace {

constexpr std::size_t cells_per_task = 4096, vertices_per_task = 4096;

std::uint32_t mix(Index v) { return static_cast<std::uint32_t>((v + 1ULL) * 0x9E3779B97F4A7C15ULL >> 32); }

// The faces whose smallest vertex is v are face[begin[v]] to face[begin[v + 1] - 1], ascending.
struct FacesByVertex {
    std::vector<Index> begin, face;
};

// Groups the faces by their smallest vertex. Skips faces of cells that are left out, and faces that collapsed to a line
// or a point and so separate no cells. All these faces stay on the boundary. `scratch`: one element for each face.
FacesByVertex group_faces(const InputFaces& input, std::span<const std::uint8_t> left_out, std::span<Index> scratch) {
    parallel_for(input.cell_count(), cells_per_task, [&](std::size_t first, std::size_t last) {
        std::vector<Index> loop;
        InputFaces::Corners corners;
        for (auto cell = static_cast<Index>(first); cell < last; ++cell)
            for (Index face = input.begin(cell); face < input.end(cell); ++face) {
                loop.clear();
                if (left_out[cell] == 0) append_without_repeats(input.loop(cell, face, corners), loop);
                scratch[face] = loop.size() < 3 ? none : *std::ranges::min_element(loop);
            }
    });
    FacesByVertex out;
    out.begin.assign(std::size_t{input.vertex_count()} + 1, 0);
    for (const Index smallest : scratch)
        if (smallest != none) ++out.begin[std::size_t{smallest} + 1];
    for (std::size_t v = 1; v < out.begin.size(); ++v) out.begin[v] += out.begin[v - 1];
    out.face.resize(out.begin.back());
    std::vector<Index> cursor(out.begin.begin(), out.begin.end() - 1);
    for (Index f = 0; f < scratch.size(); ++f)
        if (scratch[f] != none) out.face[cursor[scratch[f]]++] = f;
    return out;
}

struct FaceOfCell {
    Index face = none, cell = none;
};

// Reads and compares the loops of faces, without repeated vertices. Each thread needs its own object.
class Loops {
public:
    explicit Loops(const InputFaces& input) : input_(input) {}

    void read(FaceOfCell face, std::vector<Index>& loop) {
        loop.clear();
        append_without_repeats(input_.loop(face.cell, face.face, corners_), loop);
    }
    [[nodiscard]] Relation compare(FaceOfCell a, FaceOfCell b);

private:
    const InputFaces& input_;
    InputFaces::Corners corners_{};
    std::vector<Index> loop_a_, loop_b_;
};

Relation Loops::compare(FaceOfCell a, FaceOfCell b) {
    read(a, loop_a_);
    read(b, loop_b_);
    return compare_loops(loop_a_, loop_b_);
}

// Finds equal faces among faces with the same smallest vertex. Each thread needs its own object.
class EqualFaces {
public:
    EqualFaces(const InputFaces& input, const Loops& loops) : input_(input), loops_(loops) {}

    // Calls settle(group) for each group of two or more equal faces. The faces of a group ascend.
    template <class Settle>
    void for_groups(std::span<const Index> faces, Settle&& settle);

private:
    struct Claim {
        std::uint32_t fingerprint = 0;
        FaceOfCell of;
    };
    template <class Settle>
    void compare_all(std::span<const Claim> claims, Settle&& settle);

    const InputFaces& input_;
    Loops loops_;
    std::vector<Claim> claims_;
    std::vector<Index> loop_;
    std::vector<FaceOfCell> left_, group_, rest_;
};

template <class Settle>
void EqualFaces::for_groups(std::span<const Index> faces, Settle&& settle) {
    claims_.clear();
    for (const Index face : faces) {
        Claim claim{0, {face, input_.cell_of(face)}};
        loops_.read(claim.of, loop_);
        for (const Index v : loop_) claim.fingerprint += mix(v); // a sum does not depend on the vertex order
        claims_.push_back(claim);
    }
    std::ranges::sort(claims_, {}, [](const Claim& claim) { return std::pair(claim.fingerprint, claim.of.face); });
    for (std::size_t begin = 0, end; begin < claims_.size(); begin = end) {
        end = begin + 1;
        while (end < claims_.size() && claims_[end].fingerprint == claims_[begin].fingerprint) ++end;
        if (end > begin + 1) compare_all(std::span(claims_).subspan(begin, end - begin), settle);
    }
}

// One round is nearly always enough: faces with the same smallest vertex and fingerprint are nearly always equal.
template <class Settle>
void EqualFaces::compare_all(std::span<const Claim> claims, Settle&& settle) {
    left_.clear();
    for (const Claim& claim : claims) left_.push_back(claim.of);
    while (!left_.empty()) {
        group_.assign(1, left_[0]);
        rest_.clear();
        for (std::size_t i = 1; i < left_.size(); ++i)
            (loops_.compare(left_[0], left_[i]) == Relation::different ? rest_ : group_).push_back(left_[i]);
        if (group_.size() > 1) settle(group_);
        left_.swap(rest_);
    }
}

class Matcher {
public:
    Matcher(const InputFaces& input, JudgedCells cells) : input_(input), cells_(cells), loops_(input) {}

    MatchedFaces run();

private:
    void pair_faces();
    [[nodiscard]] std::vector<Index> suspects() const;
    bool leave_out_repeated_cells();
    bool wound_alike(Index a, Index b); // true if both loops, reversed if `turn` is set, have the same direction
    void match(Index a, Index b);
    void agree_across_faces();
    void divide_into_units(const std::vector<Index>& conflicts);
    void spread_from(Index start);
    void settle_crowd(const std::vector<Index>& group);

    const InputFaces& input_;
    JudgedCells cells_;
    MatchedFaces result_;
    std::vector<std::vector<Index>> crowds_; // groups of more than two equal faces
    Loops loops_;
    // A unit is a set of faces that are reversed together: a cell, or one lobe of a cell (CellWinding::lobes). Unit c
    // is cell c or its first lobe. The units of further lobes have numbers after all cells.
    std::vector<Index> unit_of_face_;
    std::vector<Index> cell_of_unit_;
    std::vector<std::uint8_t> divided_; // by cell: 1 if it is divided into several units
    std::vector<std::uint8_t> parity_;  // by unit: 0 not visited, 1 keep the winding, 2 reverse it
};

bool Matcher::wound_alike(Index a, Index b) {
    const Relation relation = loops_.compare({a, input_.cell_of(a)}, {b, input_.cell_of(b)});
    return (relation == Relation::same_direction) == (cells_.turn[a] == cells_.turn[b]);
}

void Matcher::match(Index a, Index b) {
    result_.partner[a] = b;
    result_.partner[b] = a;
}

// Each cell was wound outwards on its own. Therefore two adjacent cells may disagree about their common face if one is
// folded, has no volume or touches itself. For the topology, agreement is more important than positive volumes.
void Matcher::agree_across_faces() {
    std::vector<Index> conflicts;
    const auto disagree = [&](Index f) {
        return result_.partner[f] != none && f < result_.partner[f] && wound_alike(f, result_.partner[f]);
    };
    for (Index f = 0; f < result_.partner.size(); ++f)
        if (disagree(f)) conflicts.push_back(f);
    if (conflicts.empty()) return;
    divide_into_units(conflicts);
    for (const Index f : conflicts)
        if (parity_[unit_of_face_[f]] == 0) spread_from(unit_of_face_[f]);
    for (std::size_t f = 0; f < unit_of_face_.size(); ++f)
        if (unit_of_face_[f] != none && parity_[unit_of_face_[f]] == 2) cells_.turn[f] ^= 1;
    for (const Index f : conflicts)
        if (disagree(f)) { // a one-sided (Moebius) ring of cells is cut at this face
            result_.partner[result_.partner[f]] = none;
            result_.partner[f] = none;
            ++result_.internal_boundaries;
        }
}

void Matcher::divide_into_units(const std::vector<Index>& conflicts) {
    unit_of_face_.assign(input_.face_count(), none);
    for (Index cell = 0; cell < input_.cell_count(); ++cell)
        if (cells_.left_out[cell] == 0)
            std::fill_n(unit_of_face_.begin() + input_.begin(cell), input_.end(cell) - input_.begin(cell), cell);
    cell_of_unit_.resize(input_.cell_count());
    for (Index c = 0; c < cell_of_unit_.size(); ++c) cell_of_unit_[c] = c;
    std::vector<Index> cells;
    for (const Index f : conflicts) {
        cells.push_back(input_.cell_of(f));
        cells.push_back(input_.cell_of(result_.partner[f]));
    }
    std::ranges::sort(cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    divided_.assign(cells_.volume.size(), 0);
    CellWinding winding(input_);
    for (const Index cell : cells) {
        const std::vector<Index> lobes = winding.lobes(cell);
        const auto first_new = static_cast<Index>(cell_of_unit_.size());
        for (std::size_t i = 0; i < lobes.size(); ++i)
            if (lobes[i] > 0) unit_of_face_[input_.begin(cell) + i] = first_new + lobes[i] - 1;
        cell_of_unit_.resize(first_new + *std::ranges::max_element(lobes), cell);
        divided_[cell] = cell_of_unit_.size() > first_new ? 1 : 0;
    }
    parity_.assign(cell_of_unit_.size(), 0);
}

// Sets the parities of all units that are connected to `start`, so that all matched faces agree. Of the two solutions,
// chooses the one with more volume wound outwards. If there is no solution, all these units keep their winding.
void Matcher::spread_from(Index start) {
    std::vector<Index> component{start};
    bool consistent = true;
    parity_[start] = 1;
    for (std::size_t next = 0; next < component.size(); ++next) {
        const Index unit = component[next], cell = cell_of_unit_[unit];
        for (Index f = input_.begin(cell); f < input_.end(cell); ++f) {
            if (unit_of_face_[f] != unit || result_.partner[f] == none) continue;
            const Index other = unit_of_face_[result_.partner[f]];
            const bool turn = wound_alike(f, result_.partner[f]);
            const auto parity = turn ? static_cast<std::uint8_t>(3 - parity_[unit]) : parity_[unit];
            if (parity_[other] == 0) {
                parity_[other] = parity;
                component.push_back(other);
            }
            consistent = consistent && parity_[other] == parity;
        }
    }
    double balance = 0;
    for (const Index unit : component) {
        const double volume = unit < cells_.volume.size() ? cells_.volume[unit] : 0;
        balance += parity_[unit] == 1 ? volume : -volume;
    }
    for (const Index unit : component) {
        if (balance < 0) parity_[unit] = static_cast<std::uint8_t>(3 - parity_[unit]);
        if (!consistent) parity_[unit] = 1;
        if (parity_[unit] == 2 && !divided_[cell_of_unit_[unit]] && cells_.volume[unit] > 0)
            result_.inverted_cells.push_back(unit);
    }
}

// Matches more than two equal faces. A cell that collapsed to such a face has it twice, once per side. Such cells are
// put in a chain between the one or two cells that have the face once. The two faces of each such cell, and the two
// single faces, must have opposite windings. In all other cases, the faces of the group stay unmatched.
void Matcher::settle_crowd(const std::vector<Index>& group) {
    std::vector<Index> single;
    std::vector<std::array<Index, 2>> folds;
    for (std::size_t i = 0; i < group.size(); ++i) { // the faces of one cell are consecutive in `group`
        const bool twice = i + 1 < group.size() && input_.cell_of(group[i]) == input_.cell_of(group[i + 1]);
        if (!twice) {
            single.push_back(group[i]);
        } else {
            folds.push_back({group[i], group[i + 1]});
            ++i;
        }
    }
    bool possible = !single.empty() && single.size() <= 2 && !folds.empty();
    if (possible && single.size() == 2) possible = !wound_alike(single[0], single[1]);
    for (const auto& fold : folds) possible = possible && !wound_alike(fold[0], fold[1]);
    if (!possible) {
        ++result_.internal_boundaries;
        return;
    }
    Index open = single[0];
    for (const auto& fold : folds) {
        const bool first = !wound_alike(open, fold[0]);
        match(open, fold[first ? 0 : 1]);
        open = fold[first ? 1 : 0];
    }
    if (single.size() == 2) match(open, single[1]);
}

// Returns, ascending, cells with a face in crowds_ and cells whose first two matched faces lead to the same cell.
std::vector<Index> Matcher::suspects() const {
    std::vector<Index> out;
    for (const auto& crowd : crowds_)
        for (const Index f : crowd) out.push_back(input_.cell_of(f));
    for (Index cell = 0; cell < input_.cell_count(); ++cell) {
        Index other = none;
        for (Index f = input_.begin(cell); f < input_.end(cell); ++f) {
            if (result_.partner[f] == none) continue;
            const Index behind = input_.cell_of(result_.partner[f]);
            if (behind == other) out.push_back(cell);
            if (other != none) break; // only the first two matched faces are compared
            other = behind;
        }
    }
    std::ranges::sort(out);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

bool Matcher::leave_out_repeated_cells() {
    result_.repeated_cells = repeated_cells(input_, suspects());
    for (const Index cell : result_.repeated_cells) cells_.left_out[cell] = 1;
    return !result_.repeated_cells.empty();
}

void Matcher::pair_faces() {
    std::vector<Index>& partner = result_.partner;
    partner.resize(input_.face_count());
    const FacesByVertex faces = group_faces(input_, cells_.left_out, partner);
    std::ranges::fill(partner, none);
    std::vector<std::pair<std::size_t, std::vector<std::vector<Index>>>> crowds; // (first vertex, crowds of a task)
    Mutex mutex;
    parallel_for(faces.begin.size() - 1, vertices_per_task, [&](std::size_t first, std::size_t last) {
        EqualFaces equal(input_, loops_);
        std::vector<std::vector<Index>> of_task;
        for (std::size_t v = first; v < last; ++v)
            equal.for_groups(std::span(faces.face).subspan(faces.begin[v], faces.begin[v + 1] - faces.begin[v]),
                             [&](const std::vector<FaceOfCell>& group) {
                                 if (group.size() == 2) {
                                     if (group[0].cell != group[1].cell) match(group[0].face, group[1].face);
                                     return;
                                 }
                                 std::vector<Index>& crowd = of_task.emplace_back();
                                 for (const FaceOfCell& of : group) crowd.push_back(of.face);
                             });
        if (of_task.empty()) return;
        const Locked lock(mutex);
        crowds.emplace_back(first, std::move(of_task));
    });
    std::ranges::sort(crowds);
    crowds_.clear();
    for (auto& [first, of_task] : crowds) std::ranges::move(of_task, std::back_inserter(crowds_));
}

MatchedFaces Matcher::run() {
    pair_faces();
    if (leave_out_repeated_cells()) pair_faces();
    agree_across_faces();
    for (const auto& crowd : crowds_) settle_crowd(crowd);
    std::ranges::sort(result_.inverted_cells);
    return std::move(result_);
}

} // namespace

MatchedFaces match_faces(const InputFaces& input, JudgedCells cells) { return Matcher(input, cells).run(); }

} // namespace ciel::detail
