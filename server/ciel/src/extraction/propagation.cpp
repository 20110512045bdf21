#include "extraction/propagation.hpp"

#include "blocks/blocks.hpp"
#include "extraction/cut_block.hpp"
#include "fields/field_data.hpp"

#include <algorithm>
#include <cmath>

namespace ciel::detail {

namespace {

void count_half_edges(const Topology& topology, std::vector<Index>& out) {
    out.assign(topology.counts().cells, 0);
    for (Index b = 0; b < topology.block_count(); ++b) {
        const Block& block = topology.blocks().cells(b);
        for (const StandardSection& section : block.standard)
            for (Index i = 0; i < section.count(); ++i)
                out[block.cell(section.local_cell(i))] = section.shape->half_edges;
        block.with([&](const auto& polyhedra) {
            polyhedra.for_cell_faces([&](Index i, Index ref) {
                out[block.cell(polyhedra.local_cell(i))] += polyhedra.loop(ref / 2).size();
            });
        });
    }
}

} // namespace

void Propagation::begin(const Topology& topology, const Field& field) {
    topology_ = &topology;
    field_ = &field.data();
    arrived_ = false;
}

void Propagation::restart() {
    count_half_edges(*topology_, half_edges_);
    cells_.resize(topology_->block_count());
    threshold_ = -std::numeric_limits<double>::infinity();
    active_edges_.clear();
    is_active_.assign(topology_->counts().edges, 0);
    is_low_.assign(topology_->counts().vertices, 0);
    low_half_edges_.assign(half_edges_.size(), 0);
    is_listed_.assign(half_edges_.size(), 0);
    for (std::vector<Index>& cells : cells_) cells.clear();
    is_stale_.assign(cells_.size(), 0);
}

double Propagation::value(Index vertex) const { return field_->value(vertex); }

bool Propagation::below(Index a, Index b) const { return value(a) != value(b) ? value(a) < value(b) : a < b; }

// Uses next_around_vertex, because mate_face and mate_polyhedron miss cells at non-manifold edges and at boundaries.
template <Propagation::Way way>
void Propagation::pass(Index vertex) {
    is_low_[vertex] = way == Way::up ? 1 : 0;
    const HalfEdge start = topology_->half_edge_of_vertex(vertex);
    HalfEdge h = start;
    WalkEnds walk(topology_->counts());
    do {
        const Index other = topology_->vertex(h), edge = topology_->edge(h);
        if (!is_active_[edge] && std::isfinite(value(other)) &&
            (way == Way::up ? below(vertex, other) : below(other, vertex))) {
            is_active_[edge] = 1;
            active_edges_.push_back(way == Way::up ? h : topology_->mate_face(h));
        }
        turn<way>(h);
        h = topology_->next_around_vertex(h);
        walk.step(h);
    } while (h != start);
}

// Updates the cell of a half-edge that leaves the passed vertex. The paper instead turns around each active edge, also
// in cells in which nu passes no vertex.
template <Propagation::Way way>
void Propagation::turn(HalfEdge h) {
    const Index b = block_of(h), cell = topology_->cell(h);
    way == Way::up ? ++low_half_edges_[cell] : --low_half_edges_[cell];
    is_stale_[b] = 1;
    if (is_listed_[cell]) return;
    is_listed_[cell] = 1;
    cells_[b].push_back(cell - topology_->blocks().numbers.cell[b]);
}

// Step 2 of Algorithm 2. Calls pass(h) for each edge that keep(h) refuses. `pass` may append edges; the same loop
// visits these edges, so that nu can skip several small cells at once. Returns false when `stop` was requested.
template <class Keep, class Pass>
bool Propagation::propagate(const StopToken& stop, Keep&& keep, Pass&& pass) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < active_edges_.size(); ++i) {
        if (i % 4096 == 0 && stop.stop_requested()) return false;
        const HalfEdge h = active_edges_[i];
        if (keep(h)) {
            active_edges_[kept++] = h;
        } else {
            is_active_[topology_->edge(h)] = 0;
            pass(h);
        }
    }
    active_edges_.resize(kept);
    return true;
}

bool Propagation::sweep_up(double threshold, const StopToken& stop) {
    for (const Index v : field_->minima) {
        if (value(v) >= threshold) break;
        if (!is_low_[v]) pass<Way::up>(v);
    }
    return propagate(
        stop, [&](HalfEdge h) { return value(topology_->vertex(h)) >= threshold; },
        [&](HalfEdge h) {
            const Index head = topology_->vertex(h);
            if (!is_low_[head]) pass<Way::up>(head);
        });
}

bool Propagation::sweep_down(double threshold, const StopToken& stop) {
    for (const Index v : field_->maxima) {
        if (value(v) < threshold) break;
        if (is_low_[v]) pass<Way::down>(v);
    }
    const auto foot = [&](HalfEdge h) { return topology_->vertex(topology_->mate_face(h)); };
    return propagate(
        stop, [&](HalfEdge h) { return value(foot(h)) < threshold; },
        [&](HalfEdge h) {
            if (is_low_[foot(h)]) pass<Way::down>(foot(h));
        });
}

bool Propagation::reach(double nu, const StopToken& stop) {
    const double threshold = field_->threshold(nu);
    field_->make_extrema();
    if (!arrived_) restart();
    arrived_ = false;
    arrived_ = threshold >= threshold_ ? sweep_up(threshold, stop) : sweep_down(threshold, stop);
    threshold_ = threshold;
    return arrived_;
}

void Propagation::list_blocks(std::vector<Index>& out) const {
    out.clear();
    for (Index b = 0; b < cells_.size(); ++b)
        if (!cells_[b].empty()) out.push_back(b);
}

bool Propagation::settle(Index b) {
    if (is_stale_[b] == 0) return false;
    const Index begin = topology_->blocks().numbers.cell[b];
    std::erase_if(cells_[b], [&](Index local) {
        const Index cell = begin + local;
        const bool is_active = low_half_edges_[cell] != 0 && low_half_edges_[cell] != half_edges_[cell];
        if (!is_active) is_listed_[cell] = 0;
        return !is_active;
    });
    std::ranges::sort(cells_[b]);
    is_stale_[b] = 0;
    return true;
}

std::size_t Propagation::memory_bytes() const {
    std::size_t bytes = active_edges_.capacity() * sizeof(HalfEdge) + is_active_.capacity() + is_low_.capacity() +
                        is_listed_.capacity() + is_stale_.capacity() +
                        (half_edges_.capacity() + low_half_edges_.capacity()) * sizeof(Index);
    for (const std::vector<Index>& cells : cells_)
        bytes += sizeof(std::vector<Index>) + cells.capacity() * sizeof(Index);
    return bytes;
}

} // namespace ciel::detail
