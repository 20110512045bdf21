#include "oracle/twin/twin.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ciel::test {
namespace {

CutEdge edge_of(Id u, Id v) { return {std::min(u, v), std::max(u, v)}; }

// One segment for each run of high vertices of a face, from the edge where the loop leaves the run to the edge where it
// enters. Seen from outside, with a counter-clockwise loop, higher values are on its left.
struct Segment {
    Id from_high, from_low; // the loop leaves the run: high -> low
    Id to_low, to_high;     // the loop enters the run: low -> high
    bool used = false;
};

bool joins_runs(std::span<const Id> loop, std::span<const float> values, double nu) {
    std::vector<double> v;
    for (const Id id : loop) v.push_back(values[id]);
    if (v.size() == 4) // value at the saddle of the bilinear interpolation
        return (v[0] * v[2] - v[1] * v[3]) / (v[0] + v[2] - v[1] - v[3]) >= nu;
    double mean = 0;
    for (const double value : v) mean += value / static_cast<double>(v.size());
    return mean >= nu;
}

void append_segments(std::span<const Id> loop, std::span<const float> values, double nu, Joined joined,
                     std::vector<Segment>& segments) {
    const std::size_t size = loop.size();
    const auto high = [&](std::size_t i) { return values[loop[i % size]] >= nu; };
    std::vector<std::pair<std::size_t, std::size_t>> runs; // vertex before the run, last vertex of the run
    for (std::size_t entry = 0; entry < size; ++entry) {
        if (high(entry) || !high(entry + 1)) continue;
        std::size_t last = entry + 1;
        while (high(last + 1)) ++last;
        runs.emplace_back(entry, last);
    }
    const bool join = joined == Joined::asymptotic && runs.size() > 1 && joins_runs(loop, values, nu);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::size_t last = runs[i].second, entry = runs[join ? (i + 1) % runs.size() : i].first;
        segments.push_back({loop[last % size], loop[(last + 1) % size], loop[entry], loop[(entry + 1) % size]});
    }
}

// Segments that begin on an edge. The key is (high end, low end) of the edge.
using Beginnings = std::map<std::pair<Id, Id>, std::vector<std::size_t>>;

Beginnings beginnings_of(const std::vector<Segment>& segments) {
    Beginnings result;
    for (std::size_t i = segments.size(); i-- > 0;) result[{segments[i].from_high, segments[i].from_low}].push_back(i);
    return result;
}

// Builds a closed polygon, starting with an unused segment. The next segment begins on the edge where the last one
// ends.
CutPolygon link(std::vector<Segment>& segments, Beginnings& beginnings, std::size_t first, Id cell) {
    CutPolygon polygon{cell, {}};
    for (std::size_t i = first;;) {
        Segment& segment = segments[i];
        segment.used = true;
        polygon.edges.push_back(edge_of(segment.from_high, segment.from_low));
        auto& candidates = beginnings[{segment.to_high, segment.to_low}];
        while (!candidates.empty() && segments[candidates.back()].used) candidates.pop_back();
        if (candidates.empty()) return polygon;
        i = candidates.back();
    }
}

bool is_cut(const Polyhedra& mesh, std::span<const float> values, Id cell) {
    const std::vector<Loop> loops = mesh.loops(cell);
    return std::all_of(loops.begin(), loops.end(), [&](const Loop& loop) {
        return std::all_of(loop.begin(), loop.end(), [&](Id v) { return std::isfinite(values[v]); });
    });
}

std::ostream& operator<<(std::ostream& out, const CutPolygon& polygon) {
    out << "cell " << polygon.cell << ":";
    for (auto [a, b] : polygon.edges) out << " " << a << "-" << b;
    return out;
}

} // namespace

bool make_canonical(CutPolygon& polygon) {
    auto& edges = polygon.edges;
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    while (edges.size() > 1 && edges.front() == edges.back()) edges.pop_back();
    if (std::set<CutEdge>(edges.begin(), edges.end()).size() < 3) return false;
    const CutEdge least = *std::min_element(edges.begin(), edges.end());
    std::vector<CutEdge> best;
    for (std::size_t i = 0; i < edges.size(); ++i) { // the least edge may occur twice
        if (edges[i] != least) continue;
        std::vector<CutEdge> turned(edges.begin() + static_cast<std::ptrdiff_t>(i), edges.end());
        turned.insert(turned.end(), edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(i));
        if (best.empty() || turned < best) best = std::move(turned);
    }
    edges = best;
    return true;
}

Cut cut_every_cell(const Polyhedra& mesh, std::span<const float> values, double nu, Joined joined) {
    Cut cut;
    for (Id cell = 0; cell < mesh.cell_count(); ++cell) {
        if (!is_cut(mesh, values, cell)) continue;
        std::vector<Segment> segments;
        for (auto f = mesh.cell_offset[cell]; f < mesh.cell_offset[cell + 1]; ++f) {
            append_segments(mesh.face(f), values, nu, joined, segments);
        }
        Beginnings beginnings = beginnings_of(segments);
        for (std::size_t i = 0; i < segments.size(); ++i) {
            if (segments[i].used) continue;
            CutPolygon polygon = link(segments, beginnings, i, cell);
            if (!make_canonical(polygon)) continue;
            cut.active_edges.insert(polygon.edges.begin(), polygon.edges.end());
            cut.polygons.push_back(std::move(polygon));
        }
    }
    std::sort(cut.polygons.begin(), cut.polygons.end());
    return cut;
}

std::string difference(const Cut& expected, const Cut& actual) {
    std::ostringstream text;
    for (auto e : expected.active_edges) {
        if (!actual.active_edges.contains(e)) {
            text << "edge " << e.first << "-" << e.second << " should be active";
            return text.str();
        }
    }
    for (auto e : actual.active_edges) {
        if (!expected.active_edges.contains(e)) {
            text << "edge " << e.first << "-" << e.second << " should not be active";
            return text.str();
        }
    }
    std::vector<CutPolygon> missing, extra;
    std::set_difference(expected.polygons.begin(), expected.polygons.end(), actual.polygons.begin(),
                        actual.polygons.end(), std::back_inserter(missing));
    std::set_difference(actual.polygons.begin(), actual.polygons.end(), expected.polygons.begin(),
                        expected.polygons.end(), std::back_inserter(extra));
    if (missing.empty() && extra.empty()) return {};
    text << missing.size() << " polygons missing, " << extra.size() << " too many";
    if (!missing.empty()) text << "; missing " << missing.front();
    if (!extra.empty()) text << "; not expected " << extra.front();
    return text.str();
}

Segments polygon_segments(const std::vector<CutPolygon>& polygons) {
    Segments segments;
    for (const CutPolygon& polygon : polygons) {
        for (std::size_t i = 0; i < polygon.edges.size(); ++i) {
            ++segments[{polygon.edges[i], polygon.edges[(i + 1) % polygon.edges.size()]}];
        }
    }
    return segments;
}

void add_face_segments(std::span<const Id> loop, std::span<const float> values, double nu, Segments& segments,
                       Joined joined) {
    std::vector<Segment> found;
    append_segments(loop, values, nu, joined, found);
    for (const Segment& s : found) ++segments[{edge_of(s.from_high, s.from_low), edge_of(s.to_low, s.to_high)}];
}

Segments boundary_segments(const Polyhedra& mesh, std::span<const float> values, double nu, Joined joined) {
    std::map<Loop, std::vector<Loop>> claims;
    for (Id cell = 0; cell < mesh.cell_count(); ++cell) {
        if (!is_cut(mesh, values, cell)) continue;
        for (const Loop& loop : mesh.loops(cell)) {
            Loop key = loop;
            std::sort(key.begin(), key.end());
            key.erase(std::unique(key.begin(), key.end()), key.end()); // a collapsed quadrilateral matches a triangle
            claims[key].push_back(loop);
        }
    }
    Segments segments;
    for (const auto& [key, loops] : claims) {
        if (loops.size() == 2) continue;
        for (const Loop& loop : loops) add_face_segments(loop, values, nu, segments, joined);
    }
    return segments;
}

std::string open_segment(const Segments& polygons, const Segments& boundary) {
    Segments net; // count of forward minus backward segments, by undirected segment
    const auto add = [&](const Segments& segments, int sign) {
        for (const auto& [segment, count] : segments) {
            const auto [from, to] = segment;
            if (from < to) net[{from, to}] += sign * count;
            if (to < from) net[{to, from}] -= sign * count;
        }
    };
    add(polygons, 1);
    add(boundary, -1);
    for (const auto& [segment, count] : net) {
        if (count == 0) continue;
        std::ostringstream text;
        const auto [from, to] = segment;
        text << "the polygon edge between " << from.first << "-" << from.second << " and " << to.first << "-"
             << to.second << " is unmatched (" << count << ")";
        return text.str();
    }
    return {};
}

} // namespace ciel::test
