#include "mesh/matched_cells.hpp"

#include "ciel/parallel.hpp"
#include "mesh/cell_winding.hpp"
#include "mesh/face_matching.hpp"
#include "mesh/hilbert.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace ciel {

using detail::CellWinding;
using detail::hilbert_key;
using detail::InputFaces;
using detail::match_faces;
using detail::MatchedFaces;

namespace {

constexpr std::size_t cells_per_task = 4096;

struct Judged {
    std::vector<std::optional<BadCells::Reason>> bad; // by input cell
    std::vector<double> volume;                       // by input cell; absolute value
    std::vector<std::uint8_t> turn;                   // by input face: 1 if its loop must be reversed
    std::vector<Index> order;                         // the good cells along the Hilbert curve
};

std::vector<std::uint64_t> curve_keys(const Judged& judged, std::span<const Vec3d> center) {
    Vec3d low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    for (std::size_t c = 0; c < center.size(); ++c) {
        if (judged.bad[c]) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], center[c][i]);
            high[i] = std::max(high[i], center[c][i]);
        }
    }
    const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-300});
    std::vector<std::uint64_t> key(center.size());
    parallel_for(key.size(), cells_per_task, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
            const Vec3d& p = center[c];
            key[c] = hilbert_key({(p[0] - low[0]) / extent, (p[1] - low[1]) / extent, (p[2] - low[2]) / extent});
        }
    });
    return key;
}

std::vector<Index> curve_order(const Judged& judged, const std::vector<std::uint64_t>& key) {
    std::vector<Index> order;
    order.reserve(key.size());
    for (Index c = 0; c < key.size(); ++c)
        if (!judged.bad[c]) order.push_back(c);
    std::ranges::sort(order, [&](Index a, Index b) { return key[a] != key[b] ? key[a] < key[b] : a < b; });
    return order;
}

Judged judge_cells(const InputFaces& input) {
    const std::size_t cells = input.cell_count();
    Judged judged;
    judged.bad.resize(cells);
    judged.volume.resize(cells);
    judged.turn.resize(input.face_count());
    std::vector<Vec3d> center(cells);
    // Few tasks, because each CellWinding allocates a table with one entry per mesh vertex.
    const std::size_t grain = std::max(cells_per_task, cells / (std::size_t{4} * thread_count()) + 1);
    parallel_for(cells, grain, [&](std::size_t begin, std::size_t end) {
        CellWinding winding(input);
        for (std::size_t c = begin; c < end; ++c) {
            const CellWinding::Verdict verdict = winding.judge(static_cast<Index>(c), judged.turn);
            judged.bad[c] = verdict.bad;
            judged.volume[c] = verdict.volume;
            center[c] = verdict.center;
        }
    });
    judged.order = curve_order(judged, curve_keys(judged, center));
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

// Matches the faces of good cells. Returns the input cell on the other side of each input face, or none.
std::vector<Index> neighbours_of(const InputFaces& input, Judged& judged, AssembleReport& report) {
    std::vector<std::uint8_t> left_out(judged.bad.size());
    std::ranges::transform(judged.bad, left_out.begin(), [](const auto& bad) { return bad ? 1 : 0; });
    MatchedFaces matched = match_faces(input, {left_out, judged.volume, judged.turn});
    for (const Index cell : matched.repeated_cells) judged.bad[cell] = BadCells::Reason::repeated;
    report.internal_boundaries = matched.internal_boundaries;
    report.inverted_cells = matched.inverted_cells.size();
    matched.inverted_cells.resize(std::min<std::size_t>(10, matched.inverted_cells.size()));
    report.first_inverted = std::move(matched.inverted_cells);
    for (Index& of_face : matched.partner)
        if (of_face != none) of_face = input.cell_of(of_face);
    return std::move(matched.partner);
}

void number_faces(MatchedCells::Data& cells) {
    cells.own_begin.reserve(std::size_t{cells.cell_count()} + 1);
    Index faces = 0;
    for (Index cell = 0; cell < cells.cell_count(); ++cell) {
        cells.own_begin.push_back(faces);
        cells.for_faces(cell, [&](Index, Index other) { faces += other > cell ? 1 : 0; });
    }
    cells.own_begin.push_back(faces);
}

// Numbers the vertices in the order of their first use in the faces.
void number_vertices(MatchedCells::Data& cells) {
    cells.stored_vertex.assign(cells.input.vertex_count(), none);
    std::vector<MatchedCells::Data::OwnFace> own;
    InputFaces::Corners corners;
    const auto number = [&](Index vertex) {
        if (cells.stored_vertex[vertex] != none) return;
        cells.stored_vertex[vertex] = static_cast<Index>(cells.original_vertex.size());
        cells.original_vertex.push_back(vertex);
    };
    for (Index cell = 0; cell < cells.cell_count(); ++cell) {
        cells.list_own(cell, own);
        for (const auto& [other, face] : own) {
            const std::span<const Index> loop = cells.input.loop(cells.order[cell], face, corners);
            if (cells.turn[face] != 0)
                std::for_each(loop.rbegin(), loop.rend(), number);
            else
                std::ranges::for_each(loop, number);
        }
    }
}

} // namespace

// Returns polyhedron when the numbers of faces and corners do not match the type. Later code relies on these numbers.
CellType MatchedCells::Data::cell_type(Index cell) const {
    const Index source = order[cell];
    const auto type = static_cast<CellType>(input.input().cell_types[source]);
    const Index faces = input.end(source) - input.begin(source);
    std::size_t corners = 0;
    for (Index f = input.begin(source); f < input.end(source); ++f) corners += input.size(source, f);
    const bool fits = (type == CellType::tetrahedron && faces == 4 && corners == 12) ||
                      (type == CellType::hexahedron && faces == 6 && corners == 24) ||
                      (type == CellType::wedge && faces == 5 && corners == 18) ||
                      (type == CellType::pyramid && faces == 5 && corners == 16);
    return fits ? type : CellType::polyhedron;
}

void MatchedCells::Data::list_own(Index cell, std::vector<OwnFace>& out) const {
    out.clear();
    for_faces(cell, [&](Index face, Index other) {
        if (other > cell) out.push_back({other, face});
    });
    std::ranges::sort(out, {}, [](const OwnFace& own) { return std::pair(own.other, own.face); });
}

void MatchedCells::Data::append_loop(Index cell, Index face, std::vector<Index>& out) const {
    InputFaces::Corners corners;
    const std::span<const Index> loop = input.loop(order[cell], face, corners);
    const auto append = [&](Index vertex) { out.push_back(stored_vertex[vertex]); };
    if (turn[face] != 0)
        std::for_each(loop.rbegin(), loop.rend(), append);
    else
        std::ranges::for_each(loop, append);
}

FaceMesh MatchedCells::Data::points() const {
    const PolyhedraView& view = input.input();
    FaceMesh mesh;
    mesh.origin = view.origin;
    mesh.cell_types.resize(order.size());
    for (Index cell = 0; cell < cell_count(); ++cell)
        mesh.cell_types[cell] = static_cast<std::uint8_t>(cell_type(cell));
    view.positions.with([&]<class Number>(std::span<const Number> all) {
        std::vector<Number> positions;
        positions.reserve(3 * original_vertex.size());
        for (const Index v : original_vertex)
            for (std::size_t i = 0; i < 3; ++i) positions.push_back(all[3 * std::size_t{v} + i]);
        mesh.set_positions(std::move(positions));
    });
    return mesh;
}

MatchedCells::MatchedCells(const PolyhedraView& view, std::shared_ptr<const void> owner)
    : data_(std::make_unique<Data>(view, std::move(owner))) {
    if (data_->owner == nullptr) fail("the arrays of the cells have no owner; pass it, so that they stay alive");
    Judged judged = judge_cells(data_->input);
    data_->neighbour = neighbours_of(data_->input, judged, data_->report);
    judged.volume = {};
    report_bad_cells(judged, data_->report);
    report_faces(data_->input, judged, data_->report);
    data_->order = std::move(judged.order);
    std::erase_if(data_->order, [&](Index cell) { return judged.bad[cell].has_value(); }); // repeated cells
    data_->turn = std::move(judged.turn);
    std::vector<Index> rank(judged.bad.size(), none); // input cell -> stored cell
    judged = {};
    for (Index i = 0; i < data_->order.size(); ++i) rank[data_->order[i]] = i;
    for (Index& cell : data_->neighbour)
        if (cell != none) cell = rank[cell];
    rank = {};
    number_faces(*data_);
    number_vertices(*data_);
}

MatchedCells::~MatchedCells() = default;
MatchedCells::MatchedCells(MatchedCells&&) noexcept = default;
MatchedCells& MatchedCells::operator=(MatchedCells&&) noexcept = default;

const AssembleReport& MatchedCells::report() const { return data_->report; }
std::span<const Index> MatchedCells::original_vertex() const { return data_->original_vertex; }
std::span<const Index> MatchedCells::original_cell() const { return data_->order; }

FaceMesh MatchedCells::points() const { return data_->points(); }

FaceMesh MatchedCells::boundary() const {
    FaceMesh mesh = data_->points();
    std::vector<Data::OwnFace> own;
    for (Index cell = 0; cell < data_->cell_count(); ++cell) {
        data_->list_own(cell, own);
        for (const auto& [other, face] : own) {
            if (other != none) continue;
            data_->append_loop(cell, face, mesh.face_vertex);
            mesh.face_offset.push_back(mesh.face_vertex.size());
            mesh.owner.push_back(cell);
            mesh.neighbour.push_back(none);
        }
    }
    return mesh;
}

std::vector<Index> MatchedCells::corners(Index cell) const {
    std::vector<Index> corners;
    data_->for_faces(cell, [&](Index face, Index) { data_->append_loop(cell, face, corners); });
    std::ranges::sort(corners);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

} // namespace ciel
