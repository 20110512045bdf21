#include "support/polyhedra.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace ciel::test {

Id Polyhedra::add_vertex(const Point& offset) {
    for (double coordinate : offset) positions.push_back(static_cast<float>(coordinate));
    return vertex_count() - 1;
}

void Polyhedra::add_cell(std::uint8_t type, const std::vector<Loop>& loops) {
    for (const Loop& loop : loops) {
        face_vertex.insert(face_vertex.end(), loop.begin(), loop.end());
        face_offset.push_back(face_vertex.size());
    }
    cell_offset.push_back(face_count());
    cell_types.push_back(type);
}

std::vector<Loop> Polyhedra::loops(Id cell) const {
    std::vector<Loop> result;
    for (auto f = cell_offset[cell]; f < cell_offset[cell + 1]; ++f)
        result.emplace_back(face(f).begin(), face(f).end());
    return result;
}

namespace {

Polyhedra without_cells(const Polyhedra& mesh) {
    Polyhedra result;
    result.origin = mesh.origin;
    result.positions = mesh.positions;
    return result;
}

using Chance = std::bernoulli_distribution;

// True when the loops bound a manifold: each directed edge occurs once, and so does its opposite.
bool is_closed_manifold(const std::vector<Loop>& loops) {
    std::set<std::pair<Id, Id>> edges;
    for (const Loop& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            if (!edges.emplace(loop[i], loop[(i + 1) % loop.size()]).second) return false;
        }
    }
    return std::all_of(edges.begin(), edges.end(), [&](auto e) { return edges.count({e.second, e.first}) == 1; });
}

Loop sorted(Loop loop) {
    std::sort(loop.begin(), loop.end());
    return loop;
}

// The loops of two cells, without the faces that they share.
std::vector<Loop> merged(const std::vector<Loop>& first, const std::vector<Loop>& second) {
    std::map<Loop, int> uses;
    for (const auto* loops : {&first, &second}) {
        for (const Loop& loop : *loops) ++uses[sorted(loop)];
    }
    std::vector<Loop> result;
    for (const auto* loops : {&first, &second}) {
        for (const Loop& loop : *loops) {
            if (uses[sorted(loop)] == 1) result.push_back(loop);
        }
    }
    return result;
}

std::vector<std::vector<Id>> neighbours(const Polyhedra& mesh) {
    std::map<Loop, Id> first;
    std::vector<std::vector<Id>> result(mesh.cell_count());
    for (Id c = 0; c < mesh.cell_count(); ++c) {
        for (const Loop& loop : mesh.loops(c)) {
            const auto [entry, is_new] = first.emplace(sorted(loop), c);
            if (is_new) continue;
            result[c].push_back(entry->second);
            result[entry->second].push_back(c);
        }
    }
    return result;
}

} // namespace

Loop canonical(Loop loop) {
    Loop best = loop;
    for (std::size_t i = 1; i < loop.size(); ++i) {
        std::rotate(loop.begin(), loop.begin() + 1, loop.end());
        best = std::min(best, loop);
    }
    return best;
}

Loop without_repeats(Loop loop) {
    loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    return loop;
}

double signed_volume(const Polyhedra& mesh, Id cell) {
    double sum = 0;
    const Point o = mesh.position(mesh.loops(cell)[0][0]);
    const auto relative = [&](Id v) {
        const Point p = mesh.position(v);
        return Point{p[0] - o[0], p[1] - o[1], p[2] - o[2]};
    };
    for (const Loop& loop : mesh.loops(cell)) {
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            const Point a = relative(loop[0]), b = relative(loop[i]), c = relative(loop[i + 1]);
            sum += a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]);
        }
    }
    return sum / 6;
}

Polyhedra keep_cells(const Polyhedra& mesh, const std::function<bool(Id)>& keep) {
    Polyhedra result = without_cells(mesh);
    for (Id c = 0; c < mesh.cell_count(); ++c) {
        if (keep(c)) result.add_cell(mesh.cell_types[c], mesh.loops(c));
    }
    return result;
}

Polyhedra joined(const Polyhedra& first, const Polyhedra& second, const Point& shift) {
    Polyhedra result = first;
    const Id base = first.vertex_count();
    for (Id v = 0; v < second.vertex_count(); ++v) {
        Point p = second.position(v);
        for (int d = 0; d < 3; ++d) p[d] += shift[d] - first.origin[d];
        result.add_vertex(p);
    }
    for (Id c = 0; c < second.cell_count(); ++c) {
        std::vector<Loop> loops = second.loops(c);
        for (Loop& loop : loops) {
            for (Id& v : loop) v += base;
        }
        result.add_cell(second.cell_types[c], loops);
    }
    return result;
}

Polyhedra agglomerated(const Polyhedra& mesh, int size, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    auto adjacent = neighbours(mesh);
    std::vector<char> used(mesh.cell_count(), 0);
    Polyhedra result = without_cells(mesh);
    for (Id c = 0; c < mesh.cell_count(); ++c) {
        if (used[c]) continue;
        used[c] = 1;
        std::vector<Loop> loops = mesh.loops(c);
        int cells = 1;
        for (Id last = c; cells < size; ++cells) {
            std::shuffle(adjacent[last].begin(), adjacent[last].end(), random);
            const auto next = std::find_if(adjacent[last].begin(), adjacent[last].end(), [&](Id n) {
                return !used[n] && is_closed_manifold(merged(loops, mesh.loops(n)));
            });
            if (next == adjacent[last].end()) break;
            loops = merged(loops, mesh.loops(*next));
            last = *next;
            used[last] = 1;
        }
        result.add_cell(cells == 1 ? mesh.cell_types[c] : polyhedron, loops);
    }
    return result;
}

Shuffled shuffled(const Polyhedra& mesh, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Shuffled result{without_cells(mesh), std::vector<Id>(mesh.cell_count())};
    std::iota(result.cell_of.begin(), result.cell_of.end(), Id{0});
    std::shuffle(result.cell_of.begin(), result.cell_of.end(), random);
    for (Id c : result.cell_of) {
        std::vector<Loop> loops = mesh.loops(c);
        std::shuffle(loops.begin(), loops.end(), random);
        for (Loop& loop : loops) {
            std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(random() % loop.size()), loop.end());
        }
        result.mesh.add_cell(mesh.cell_types[c], loops);
    }
    return result;
}

Polyhedra with_turned_faces(const Polyhedra& mesh, double share, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Chance turn(share);
    Polyhedra result = mesh;
    for (std::uint64_t f = 0; f < mesh.face_count(); ++f) {
        const auto begin = result.face_vertex.begin();
        const auto at = [&](std::uint64_t offset) { return begin + static_cast<std::ptrdiff_t>(offset); };
        if (turn(random)) std::reverse(at(mesh.face_offset[f]), at(mesh.face_offset[f + 1]));
    }
    return result;
}

Polyhedra with_turned_cells(const Polyhedra& mesh, double share, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Chance turn(share);
    Polyhedra result = without_cells(mesh);
    for (Id c = 0; c < mesh.cell_count(); ++c) {
        std::vector<Loop> loops = mesh.loops(c);
        if (turn(random)) {
            for (Loop& loop : loops) std::reverse(loop.begin(), loop.end());
        }
        result.add_cell(mesh.cell_types[c], loops);
    }
    return result;
}

} // namespace ciel::test
