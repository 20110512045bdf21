// Algorithms 1 and 3 of the paper: move the active edges to nu, intersect them, and cut the cells around them.
#include "extraction/surface_writer.hpp"

namespace ciel {

using namespace detail;

namespace {

std::unique_ptr<Cutter> make_cutter(Algorithm algorithm, const Topology& topology) {
    switch (algorithm) {
    case Algorithm::propagation:
        return make_propagation_cutter(topology);
    case Algorithm::naive:
        return make_naive_cutter(topology);
    case Algorithm::signatures:
        break;
    }
    return make_signature_cutter(topology);
}

} // namespace

struct Query::State {
    Topology topology;
    FaceMeshView mesh;
    std::unique_ptr<Cutter> cutter; // refers to `topology` and `field`
    std::optional<Field> field{};
    Normals normals = Normals::gradient;
    SurfaceScratch scratch{};
};

Query::Query(const Topology& topology, const FaceMeshView& mesh, Extraction extraction)
    : state_(std::make_unique<State>(State{topology, mesh, nullptr})) {
    state_->cutter = make_cutter(extraction.algorithm, state_->topology);
    set_mesh(mesh);
    set_decider(extraction.decider);
}

void Query::set_mesh(const FaceMeshView& mesh) {
    const TopologyCounts& counts = state_->topology.counts();
    if (mesh.vertex_count() != counts.vertices || mesh.cell_count() != counts.cells)
        fail("the mesh and the topology differ; pass the mesh from which the topology was built");
    state_->mesh = mesh.owned();
}

void Query::set_normals(Normals normals) { state_->normals = normals; }

void Query::set_decider(Decider decider) { state_->cutter->set_decider(decider); }

void Query::set_blocks(std::optional<std::span<const Index>> blocks) { state_->cutter->set_blocks(blocks); }

Query::~Query() = default;
Query::Query(Query&&) noexcept = default;
Query& Query::operator=(Query&&) noexcept = default;

void Query::set_field(const Field& field) {
    if (!field.data().is_of(state_->topology))
        fail("the field belongs to another topology; make the field from the topology of the query");
    state_->field = field;
    state_->cutter->set_field(*state_->field);
}

bool Query::extract(double nu, bool normals, Surface& out, const StopToken& stop) {
    if (!state_->field) fail("the query has no field; call set_field before extract");
    if (!state_->cutter->update(nu, stop)) return false;
    write_surface(state_->topology, state_->mesh, state_->field->data(), *state_->cutter, nu,
                  normals ? std::optional(state_->normals) : std::nullopt, state_->scratch, out);
    return !stop.stop_requested();
}

std::size_t Query::memory_bytes() const {
    return sizeof(State) + state_->cutter->memory_bytes() + state_->scratch.memory_bytes();
}

bool extract_series(Query& query, std::span<const double> values, bool normals,
                    const std::function<void(double nu, Surface&&)>& sink, const StopToken& stop) {
    Surface surface;
    for (const double nu : values) {
        if (!query.extract(nu, normals, surface, stop)) return false;
        sink(nu, std::move(surface));
        // The sink may have moved from `surface`. The next call of extract replaces its contents.
    }
    return true;
}

} // namespace ciel
