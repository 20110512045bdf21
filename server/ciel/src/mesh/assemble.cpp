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
using detail::match_faces;
using detail::MatchedFaces;

namespace {

constexpr std::size_t cells_per_task = 4096;

void check_offsets(std::span<const std::uint64_t> offsets, std::uint64_t end, const std::string& name) {
    if (offsets.empty() || offsets.front() != 0 || !std::ranges::is_sorted(offsets) || offsets.back() != end)
        fail(name + " must rise from 0 to " + std::to_string(end) + ", the length of the array that it indexes");
}

void check_sizes(const PolyhedraView& input) {
    if (input.positions.size() % 3 != 0) fail("positions must hold three numbers per vertex");
    if (input.positions.size() / 3 >= none || input.cell_types.size() >= none || input.face_offset.size() > none)
        fail("the mesh has more than 4,294,967,294 vertices, cells or faces; split the dataset");
    if (input.cell_offset.size() != input.cell_types.size() + 1)
        fail("cell_offset must hold one number more than there are cells (" + std::to_string(input.cell_types.size()) +
             ")");
    check_offsets(input.cell_offset, input.face_offset.empty() ? 0 : input.face_offset.size() - 1, "cell_offset");
    check_offsets(input.face_offset, input.face_vertex.size(), "face_offset");
    for (const std::uint8_t type : input.cell_types)
        if (type != 10 && type != 12 && type != 13 && type != 14 && type != 42)
            fail("cell type " + std::to_string(type) +
                 " is not known; use 10 (tetrahedron), 12 (hexahedron), 13 (wedge), 14 (pyramid) or 42 (polyhedron)");
}

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

Judged judge_cells(const PolyhedraView& input) {
    const std::size_t cells = input.cell_types.size();
    Judged judged;
    judged.bad.resize(cells);
    judged.volume.resize(cells);
    judged.turn.resize(input.face_offset.size() - 1);
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

void report_faces(const PolyhedraView& input, const Judged& judged, AssembleReport& report) {
    for (std::size_t c = 0; c < judged.bad.size(); ++c) {
        if (judged.bad[c]) continue;
        std::uint64_t faces = 0, turned = 0, short_faces = 0;
        for (std::uint64_t f = input.cell_offset[c]; f < input.cell_offset[c + 1]; ++f) {
            const bool is_face = input.is_face(f);
            faces += is_face ? 1 : 0;
            turned += is_face && judged.turn[f] ? 1 : 0;
            short_faces += is_face ? 0 : 1;
        }
        report.short_faces += short_faces;
        if (short_faces > 0 && report.first_short.size() < 10) report.first_short.push_back(static_cast<Index>(c));
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
CellType checked_type(const PolyhedraView& input, Index cell) {
    const auto type = static_cast<CellType>(input.cell_types[cell]);
    const std::uint64_t faces = input.cell_offset[cell + 1] - input.cell_offset[cell];
    const std::uint64_t corners =
        input.face_offset[input.cell_offset[cell + 1]] - input.face_offset[input.cell_offset[cell]];
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
    FaceWriter(const PolyhedraView& input, std::span<const Index> order, std::span<const Index> neighbour,
               std::span<const std::uint8_t> turn)
        : input_(input), order_(order), neighbour_(neighbour), turn_(turn) {}

    void write(Assembled& out) {
        list_faces(out);
        out.mesh.face_offset.resize(out.face_source.size() + 1);
        for (std::size_t f = 0; f < out.face_source.size(); ++f) {
            const std::uint64_t source = out.face_source[f];
            out.mesh.face_offset[f + 1] =
                out.mesh.face_offset[f] + input_.face_offset[source + 1] - input_.face_offset[source];
        }
        out.mesh.face_vertex.resize(out.mesh.face_offset.back());
        parallel_for(out.face_source.size(), cells_per_task, [&](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f) copy_loop(out, f);
        });
    }

private:
    // Calls f(input face) for the faces that the stored cell owns.
    template <class F>
    void for_own_faces(Index cell, F&& f) const {
        const Index source = order_[cell];
        for (std::uint64_t face = input_.cell_offset[source]; face < input_.cell_offset[source + 1]; ++face)
            if (input_.is_face(face) && neighbour_[face] > cell) f(face);
    }

    void list_faces(Assembled& out) const {
        std::size_t count = 0;
        for (Index cell = 0; cell < order_.size(); ++cell) for_own_faces(cell, [&](std::uint64_t) { ++count; });
        out.mesh.owner.reserve(count);
        out.mesh.neighbour.reserve(count);
        out.face_source.reserve(count);
        std::vector<std::pair<Index, std::uint64_t>> faces; // of one cell: (stored cell on the other side, input face)
        for (Index cell = 0; cell < order_.size(); ++cell) {
            faces.clear();
            for_own_faces(cell, [&](std::uint64_t face) { faces.emplace_back(neighbour_[face], face); });
            std::ranges::sort(faces);
            for (const auto& [other, face] : faces) {
                out.mesh.owner.push_back(cell);
                out.mesh.neighbour.push_back(other);
                out.face_source.push_back(face);
            }
        }
    }

    void copy_loop(Assembled& out, std::size_t face) const {
        const std::uint64_t source = out.face_source[face];
        const auto loop = input_.face_vertex.subspan(input_.face_offset[source],
                                                     input_.face_offset[source + 1] - input_.face_offset[source]);
        const auto to = out.mesh.face_vertex.begin() + static_cast<std::ptrdiff_t>(out.mesh.face_offset[face]);
        if (turn_[source])
            std::ranges::reverse_copy(loop, to);
        else
            std::ranges::copy(loop, to);
    }

    const PolyhedraView& input_;
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

} // namespace

namespace {

// Matches the faces of good cells. Returns the input cell on the other side of each input face, or none.
std::vector<Index> neighbours_of(const PolyhedraView& input, Judged& judged, AssembleReport& report) {
    std::vector<Index> cell_of_face(judged.turn.size(), none);
    for (Index c = 0; c < judged.bad.size(); ++c)
        if (!judged.bad[c])
            std::fill(cell_of_face.begin() + static_cast<std::ptrdiff_t>(input.cell_offset[c]),
                      cell_of_face.begin() + static_cast<std::ptrdiff_t>(input.cell_offset[c + 1]), c);
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

Assembled assemble(const PolyhedraView& input) {
    check_sizes(input);
    Assembled out;
    out.mesh.origin = input.origin;
    Judged judged = judge_cells(input);
    std::vector<Index> neighbour = neighbours_of(input, judged, out.report);
    judged.volume = {};
    report_bad_cells(judged, out.report);
    report_faces(input, judged, out.report);

    out.original_cell = curve_order(judged);
    judged.key = {};
    for (const Index cell : out.original_cell)
        out.mesh.cell_types.push_back(static_cast<std::uint8_t>(checked_type(input, cell)));
    std::vector<Index> rank(judged.bad.size(), none); // input cell -> stored cell
    for (Index i = 0; i < out.original_cell.size(); ++i) rank[out.original_cell[i]] = i;
    for (Index& cell : neighbour)
        if (cell != none) cell = rank[cell];
    rank = {};
    FaceWriter(input, out.original_cell, neighbour, judged.turn).write(out);
    number_vertices(input, out);
    return out;
}

} // namespace ciel
