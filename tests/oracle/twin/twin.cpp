#include "oracle/twin/twin.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ciel::test {
namespace {

CutEdge edge_of(Id u, Id v) { return {std::min(u, v), std::max(u, v)}; }

// One segment per run of high vertices of the face. Seen from outside, with the loop counter-clockwise, higher values
// lie on the segment's left when it goes from where the loop leaves the run to where it entered.
struct Segment {
    Id from_high, from_low; // the loop leaves the run: high -> low
    Id to_low, to_high;     // the loop enters the run: low -> high
    bool used = false;
};

void append_segments(std::span<const Id> loop, std::span<const float> values, double nu,
                     std::vector<Segment>& segments) {
    const std::size_t size = loop.size();
    const auto high = [&](std::size_t i) { return values[loop[i % size]] >= nu; };
    for (std::size_t entry = 0; entry < size; ++entry) {
        if (high(entry) || !high(entry + 1)) continue;
        std::size_t last = entry + 1;
        while (high(last + 1)) ++last;
        segments.push_back({loop[last % size], loop[(last + 1) % size], loop[entry], loop[(entry + 1) % size]});
    }
}

// A closed polygon from one unused segment on: the next begins on the same edge, walked the other way.
CutPolygon link(std::vector<Segment>& segments, std::size_t first, Id cell) {
    CutPolygon polygon{cell, {}};
    for (Segment* segment = &segments[first]; segment != nullptr;) {
        segment->used = true;
        polygon.edges.push_back(edge_of(segment->from_high, segment->from_low));
        const auto next = std::find_if(segments.begin(), segments.end(), [&](const Segment& s) {
            return !s.used && s.from_high == segment->to_high && s.from_low == segment->to_low;
        });
        segment = next == segments.end() ? nullptr : &*next;
    }
    return polygon;
}

bool touches_nan(const CutPolygon& polygon, std::span<const float> values) {
    return std::any_of(polygon.edges.begin(), polygon.edges.end(),
                       [&](CutEdge e) { return std::isnan(values[e.first]) || std::isnan(values[e.second]); });
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
    std::vector<CutEdge> best = edges;
    for (std::size_t i = 1; i < edges.size(); ++i) {
        std::rotate(edges.begin(), edges.begin() + 1, edges.end());
        best = std::min(best, edges);
    }
    edges = best;
    return true;
}

Cut cut_every_cell(const Polyhedra& mesh, std::span<const float> values, double nu) {
    Cut cut;
    for (Id cell = 0; cell < mesh.cell_count(); ++cell) {
        std::vector<Segment> segments;
        for (auto f = mesh.cell_offset[cell]; f < mesh.cell_offset[cell + 1]; ++f) {
            append_segments(mesh.face(f), values, nu, segments);
        }
        for (const Segment& s : segments) {
            if (!std::isnan(values[s.to_low])) cut.active_edges.insert(edge_of(s.to_low, s.to_high));
            if (!std::isnan(values[s.from_low])) cut.active_edges.insert(edge_of(s.from_low, s.from_high));
        }
        for (std::size_t i = 0; i < segments.size(); ++i) {
            if (segments[i].used) continue;
            CutPolygon polygon = link(segments, i, cell);
            if (!touches_nan(polygon, values) && make_canonical(polygon)) cut.polygons.push_back(std::move(polygon));
        }
    }
    std::sort(cut.polygons.begin(), cut.polygons.end());
    return cut;
}

std::string difference(const Cut& expected, const Cut& actual) {
    std::ostringstream text;
    std::set<CutEdge> drawn;
    for (const CutPolygon& polygon : expected.polygons) drawn.insert(polygon.edges.begin(), polygon.edges.end());
    // An edge that only dropped polygons touch may be listed or not.
    for (auto e : drawn) {
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

Segments boundary_segments(const Polyhedra& mesh, std::span<const float> values, double nu) {
    std::map<Loop, std::vector<std::uint64_t>> claims;
    for (std::uint64_t f = 0; f < mesh.face_count(); ++f) {
        Loop key(mesh.face(f).begin(), mesh.face(f).end());
        std::sort(key.begin(), key.end());
        key.erase(std::unique(key.begin(), key.end()), key.end()); // a quad collapsed to a triangle meets triangles
        claims[key].push_back(f);
    }
    std::vector<Segment> found;
    for (const auto& [key, faces] : claims) {
        if (faces.size() == 2) continue;
        for (auto f : faces) append_segments(mesh.face(f), values, nu, found);
    }
    Segments segments;
    for (const Segment& s : found) ++segments[{edge_of(s.from_high, s.from_low), edge_of(s.to_low, s.to_high)}];
    return segments;
}

std::string open_segment(const Segments& polygons, const Segments& boundary) {
    Segments net; // what leaves minus what comes back, by undirected segment
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
