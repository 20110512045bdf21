#include "ciel/assemble.hpp"

#include "ciel/parallel.hpp"
#include "mesh/cell_winding.hpp"
#include "mesh/face_matching.hpp"
#include "mesh/hilbert.hpp"

#include <algorithm>
#include <optional>

namespace ciel {

using detail::CellWinding;
using detail::hilbert_key;
using detail::InputFaces;
using detail::match_faces;
using detail::MatchedFaces;

namespace {

constexpr std::size_t cells_per_task = 4096;

struct Judged {
    // By input cell. `key`: the place on the Hilbert curve.
    std::vector<std::optional<BadCells::Reason>> bad;
    std::vector<double> volume; // absolute value
    std::vector<std::uint64_t> key;
    std::vector<std::uint8_t> turn; // per input face: 1 if its loop must be reversed
};

std::vector<std::uint64_t> curve_keys(const Judged& judged, std::span<const Vec3d> centre) {
    Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    for (std::size_t c = 0; c < centre.size(); ++c) {
        if (judged.bad[c]) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], centre[c][i]);
            high[i] = std::max(high[i], centre[c][i]);
        }
    }
    const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-300});
    std::vector<std::uint64_t> key(centre.size());
    parallel_for(key.size(), cells_per_task, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
            const Vec3d& p = centre[c];
            key[c] = hilbert_key({(p[0] - low[0]) / extent, (p[1] - low[1]) / extent, (p[2] - low[2]) / extent});
        }
    });
    return key;
}

Judged judge_cells(const InputFaces& input) {
    const std::size_t cells = input.cell_count();
    Judged judged;
    judged.bad.resize(cells);
    judged.volume.resize(cells);
    judged.turn.resize(input.face_count());
    std::vector<Vec3d> centre(cells);
    // Few tasks, because each CellWinding allocates a table with one entry per mesh vertex.
    const std::size_t grain = std::max(cells_per_task, cells / (std::size_t{4} * thread_count()) + 1);
    parallel_for(cells, grain, [&](std::size_t begin, std::size_t end) {
        CellWinding winding(input);
        for (std::size_t c = begin; c < end; ++c) {
            const CellWinding::Verdict verdict = winding.judge(static_cast<Index>(c), judged.turn);
            judged.bad[c] = verdict.bad;
            judged.volume[c] = verdict.volume;
            centre[c] = verdict.centre;
        }
    });
    judged.key = curve_keys(judged, centre);
    return judged;
}

void report_bad_cells(const Judged& judged, AssembleReport& report) {
    for (std::size_t c = 0; c < judged.bad.size(); ++c) {
        const auto& bad = judged.bad[c];
        if (!bad) continue;
        auto entry = std::ranges::find(report.bad_cells, *bad, &BadCells::reason);
        if (entry == report.bad_cells.end()) entry = report.bad_cells.insert(entry, BadCells{*bad, 0, {}});
        ++entry->count;
        if (entry->first_ids.size() < 10) entry->first_ids.push_back(static_cast<Index>(c));
    }
}

void report_faces(const InputFaces& input, const Judged& judged, AssembleReport& report) {
    for (Index c = 0; c < judged.bad.size(); ++c) {
        if (judged.bad[c]) continue;
        std::uint64_t faces = 0, turned = 0, short_faces = 0;
        for (Index f = input.begin(c); f < input.end(c); ++f) {
            const bool is_face = input.is_face(c, f);
            faces += is_face ? 1 : 0;
            turned += is_face && judged.turn[f] ? 1 : 0;
            short_faces += is_face ? 0 : 1;
        }
        report.short_faces += short_faces;
        if (short_faces > 0 && report.first_short.size() < 10) report.first_short.push_back(c);
        if (turned == faces)
            ++report.reversed_cells;
        else
            report.reversed_faces += turned;
    }
}

// Returns the good cells along the curve.
std::vector<Index> curve_order(const Judged& judged) {
    const std::vector<std::uint64_t>& key = judged.key;
    std::vector<Index> order;
    order.reserve(key.size());
    for (Index c = 0; c < key.size(); ++c)
        if (!judged.bad[c]) order.push_back(c);
    std::ranges::sort(order, [&](Index a, Index b) { return key[a] != key[b] ? key[a] < key[b] : a < b; });
    return order;
}

// Returns polyhedron when the numbers of faces and corners do not match the type. Later code relies on these numbers.
CellType checked_type(const InputFaces& input, Index cell) {
    const auto type = static_cast<CellType>(input.input().cell_types[cell]);
    const Index faces = input.end(cell) - input.begin(cell);
    std::size_t corners = 0;
    for (Index f = input.begin(cell); f < input.end(cell); ++f) corners += input.size(cell, f);
    const bool fits = (type == CellType::tetrahedron && faces == 4 && corners == 12) ||
                      (type == CellType::hexahedron && faces == 6 && corners == 24) ||
                      (type == CellType::wedge && faces == 5 && corners == 18) ||
                      (type == CellType::pyramid && faces == 5 && corners == 16);
    return fits ? type : CellType::polyhedron;
}

// The loops hold input vertex ids until number_vertices renumbers them.
class FaceWriter {
public:
    // `neighbour`: input face -> stored cell on the other side, or none.
    FaceWriter(const InputFaces& input, std::span<const Index> order, std::span<const Index> neighbour,
               std::span<const std::uint8_t> turn)
        : input_(input), order_(order), neighbour_(neighbour), turn_(turn) {}

    void write(FaceMesh& out) const {
        list_faces(out);
        out.face_vertex.resize(out.face_offset.back());
        parallel_for(order_.size(), cells_per_task, [&](std::size_t begin, std::size_t end) {
            OwnFaces faces;
            auto at = static_cast<std::size_t>(std::ranges::lower_bound(out.owner, begin) - out.owner.begin());
            for (auto cell = static_cast<Index>(begin); cell < end; ++cell) {
                own_faces(cell, faces);
                for (const auto& [other, face] : faces) copy_loop(order_[cell], face, out, at++);
            }
        });
    }

private:
    using OwnFaces = std::vector<std::pair<Index, Index>>; // (stored cell on the other side, input face), ascending

    // Calls f(input face) for the faces that the stored cell owns.
    template <class F>
    void for_own_faces(Index cell, F&& f) const {
        const Index source = order_[cell];
        for (Index face = input_.begin(source); face < input_.end(source); ++face)
            if (neighbour_[face] > cell && input_.is_face(source, face)) f(face);
    }
    void own_faces(Index cell, OwnFaces& out) const {
        out.clear();
        for_own_faces(cell, [&](Index face) { out.emplace_back(neighbour_[face], face); });
        std::ranges::sort(out);
    }

    void list_faces(FaceMesh& out) const {
        std::size_t count = 0;
        for (Index cell = 0; cell < order_.size(); ++cell) for_own_faces(cell, [&](Index) { ++count; });
        out.owner.reserve(count);
        out.neighbour.reserve(count);
        out.face_offset.reserve(count + 1);
        out.face_offset.assign(1, 0);
        OwnFaces faces;
        for (Index cell = 0; cell < order_.size(); ++cell) {
            own_faces(cell, faces);
            for (const auto& [other, face] : faces) {
                out.owner.push_back(cell);
                out.neighbour.push_back(other);
                out.face_offset.push_back(out.face_offset.back() + input_.size(order_[cell], face));
            }
        }
    }

    void copy_loop(Index source, Index face, FaceMesh& out, std::size_t stored) const {
        InputFaces::Corners corners;
        const std::span<const Index> loop = input_.loop(source, face, corners);
        const auto to = out.face_vertex.begin() + static_cast<std::ptrdiff_t>(out.face_offset[stored]);
        if (turn_[face])
            std::ranges::reverse_copy(loop, to);
        else
            std::ranges::copy(loop, to);
    }

    const InputFaces& input_;
    std::span<const Index> order_, neighbour_;
    std::span<const std::uint8_t> turn_;
};

void number_vertices(const PolyhedraView& input, Assembled& out) {
    std::vector<Index> stored(input.positions.size() / 3, none);
    for (Index& v : out.mesh.face_vertex) {
        if (stored[v] == none) {
            stored[v] = static_cast<Index>(out.original_vertex.size());
            out.original_vertex.push_back(v);
        }
        v = stored[v];
    }
    input.positions.with([&]<class Number>(std::span<const Number> all) {
        std::vector<Number> positions;
        positions.reserve(3 * out.original_vertex.size());
        for (const Index v : out.original_vertex)
            for (std::size_t i = 0; i < 3; ++i) positions.push_back(all[3 * std::size_t{v} + i]);
        out.mesh.set_positions(std::move(positions));
    });
}

// Matches the faces of good cells. Returns the input cell on the other side of each input face, or none.
std::vector<Index> neighbours_of(const InputFaces& input, Judged& judged, AssembleReport& report) {
    std::vector<Index> cell_of_face(judged.turn.size(), none);
    for (Index c = 0; c < judged.bad.size(); ++c)
        if (!judged.bad[c])
            std::ranges::fill(std::span(cell_of_face).subspan(input.begin(c), input.end(c) - input.begin(c)), c);
    MatchedFaces matched = match_faces(input, {cell_of_face, judged.volume, judged.turn});
    for (const Index cell : matched.repeated_cells) judged.bad[cell] = BadCells::Reason::repeated;
    report.internal_boundaries = matched.internal_boundaries;
    report.inverted_cells = matched.inverted_cells.size();
    matched.inverted_cells.resize(std::min<std::size_t>(10, matched.inverted_cells.size()));
    report.first_inverted = std::move(matched.inverted_cells);
    for (Index& of_face : matched.partner)
        if (of_face != none) of_face = cell_of_face[of_face];
    return std::move(matched.partner);
}

} // namespace

Assembled assemble(const PolyhedraView& view) {
    const InputFaces input(view);
    Assembled out;
    out.mesh.origin = view.origin;
    Judged judged = judge_cells(input);
    std::vector<Index> neighbour = neighbours_of(input, judged, out.report);
    judged.volume = {};
    report_bad_cells(judged, out.report);
    report_faces(input, judged, out.report);

    out.original_cell = curve_order(judged);
    judged.key = {};
    out.mesh.cell_types.reserve(out.original_cell.size());
    for (const Index cell : out.original_cell)
        out.mesh.cell_types.push_back(static_cast<std::uint8_t>(checked_type(input, cell)));
    std::vector<Index> rank(judged.bad.size(), none); // input cell -> stored cell
    for (Index i = 0; i < out.original_cell.size(); ++i) rank[out.original_cell[i]] = i;
    for (Index& cell : neighbour)
        if (cell != none) cell = rank[cell];
    rank = {};
    FaceWriter(input, out.original_cell, neighbour, judged.turn).write(out.mesh);
    neighbour = {};
    number_vertices(view, out);
    return out;
}

} // namespace ciel
