#include "demo/demo.hpp"

#include "ciel/parallel.hpp"
#include "ciel/topology.hpp"
#include "demo/bed.hpp"
#include "demo/dye.hpp"
#include "demo/flow.hpp"
#include "store/writer.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace server::demo {
namespace {

constexpr std::size_t steps = 20;
constexpr std::size_t vertices_per_task = 4096;

enum Patch { inlet, outlet, bottom, top, back, front, cylinder, patches };
constexpr std::array<const char*, patches> patch_names{"inlet", "outlet", "bottom", "top", "back", "front", "cylinder"};

// Compares coordinates exactly, because corners on a side of the box have the exact coordinate of the side.
Patch patch_of(const ciel::FaceMesh& mesh, ciel::Index face, const std::array<float, 6>& sides) {
    const auto view = mesh.view();
    for (int side = 0; side < 6; ++side) {
        bool on_side = true;
        for (const ciel::Index vertex : view.loop(face))
            on_side &= mesh.positions[3 * std::size_t{vertex} + static_cast<std::size_t>(side / 2)] ==
                       sides[static_cast<std::size_t>(side)];
        if (on_side) return static_cast<Patch>(side);
    }
    return cylinder;
}

std::vector<store::NamedGroup> name_groups(const ciel::FaceMesh& mesh, const Bed& bed) {
    std::array<float, 6> sides{};
    int side = 0;
    for (const double at : {bed.x.front(), bed.x.back(), bed.y.front(), bed.y.back(), bed.z.front(), bed.z.back()})
        sides[static_cast<std::size_t>(side++)] = static_cast<float>(at);
    std::vector<store::NamedGroup> groups;
    groups.reserve(std::size(patch_names) + 2);
    for (const char* name : patch_names) groups.push_back({store::Group::Of::faces, name, {}});
    for (ciel::Index face = 0; face < mesh.owner.size(); ++face)
        if (mesh.neighbour[face] == ciel::none) groups[patch_of(mesh, face, sides)].ids.push_back(face);
    store::NamedGroup voronoi{store::Group::Of::cells, "voronoi", {}},
        hexahedra{store::Group::Of::cells, "hexahedra", {}};
    for (ciel::Index cell = 0; cell < mesh.cell_types.size(); ++cell) {
        const bool is_hexahedron = mesh.cell_types[cell] == static_cast<std::uint8_t>(ciel::CellType::hexahedron);
        (is_hexahedron ? hexahedra : voronoi).ids.push_back(cell);
    }
    groups.push_back(std::move(voronoi));
    groups.push_back(std::move(hexahedra));
    return groups;
}

std::vector<bool> wall_vertices(const ciel::FaceMesh& mesh, const store::NamedGroup& wall) {
    const auto view = mesh.view();
    std::vector<bool> on_wall(mesh.positions.size() / 3);
    for (const ciel::Index face : wall.ids)
        for (const ciel::Index vertex : view.loop(face)) on_wall[vertex] = true;
    return on_wall;
}

struct Fields {
    std::vector<float> velocity, vorticity, tracer;
};

void compute(const ciel::FaceMesh& mesh, const Bed& bed, const std::vector<bool>& on_wall, const Dye& dye, double time,
             Fields& fields) {
    const std::size_t count = mesh.positions.size() / 3;
    fields.velocity.resize(3 * count);
    fields.vorticity.resize(count);
    fields.tracer.resize(count);
    ciel::parallel_for(count, vertices_per_task, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double x = mesh.positions[3 * i], y = mesh.positions[3 * i + 1], z = mesh.positions[3 * i + 2];
            const double phase = time + span_phase(z, bed.z.back());
            FlowSample sample = Flow(phase).at(x, y);
            if (on_wall[i]) sample.u = sample.v = 0; // no slip; the wall is a polygon, partly inside r = 1
            fields.velocity[3 * i] = static_cast<float>(sample.u);
            fields.velocity[3 * i + 1] = static_cast<float>(sample.v);
            fields.velocity[3 * i + 2] = 0;
            fields.vorticity[i] = static_cast<float>(sample.vorticity);
            fields.tracer[i] = dye.at(x, y, sample.u, sample.v, phase);
        }
    });
}

ciel::FaceMesh make_mesh(const Bed& bed) {
    CellSoup soup = voronoi_cells(bed);
    soup.add(hexahedra(bed));
    const WeldedCells welded = weld(soup);
    ciel::Assembled assembled = ciel::assemble(welded.view());
    if (!assembled.report.bad_cells.empty() || assembled.report.inverted_cells > 0)
        throw ciel::Error("the demo's mesh has cells that do not close; report the failure with the version of voro++");
    return std::move(assembled.mesh);
}

store::DatasetHeader header_of(const ciel::FaceMesh& mesh) {
    const ciel::TopologyCounts counts = ciel::Topology(mesh.view()).counts();
    return {
        "ciel demo",
        "cylinder radii",
        counts.vertices,
        counts.edges,
        counts.cells,
        {"Flow past a cylinder after C. Jung, T. Tel, E. Ziemniak, Chaos 3, 555 (1993), with a phase that varies along "
         "the span; times are shedding periods and the steps make one whole period."}};
}

} // namespace

void write_demo(const std::filesystem::path& directory, bool overwrite, int coarseness,
                const std::function<void(double share, const char* what)>& progress) {
    progress(0, "Voronoi cells and hexahedra");
    const Bed bed(coarseness);
    const ciel::FaceMesh mesh = make_mesh(bed);
    store::Writer writer(directory, header_of(mesh), overwrite);
    progress(0.3, "writing the mesh");
    const auto groups = name_groups(mesh, bed);
    // Original ids are ids in an imported file. The demo imports no file, so they equal the ids in the dataset.
    std::vector<ciel::Index> ids(std::max(mesh.positions.size() / 3, mesh.cell_types.size()));
    std::iota(ids.begin(), ids.end(), 0U);
    writer.add_mesh(mesh, std::span(ids).first(mesh.positions.size() / 3), std::span(ids).first(mesh.cell_types.size()),
                    groups);

    progress(0.5, "dye");
    const Dye dye({bed.x.front(), bed.x.back(), bed.y.front(), bed.y.back()});
    const auto on_wall = wall_vertices(mesh, groups[cylinder]);
    const store::ArrayInfo velocity{"U", store::Association::point, 3, "R/T", "velocity"},
        vorticity{"vorticity", store::Association::point, 1, "1/T", "of the spanwise axis"},
        tracer{"tracer", store::Association::point, 1, "", "dye released by the cylinder"};
    Fields fields;
    for (std::size_t step = 0; step < steps; ++step) {
        const double share = static_cast<double>(step) / steps;
        progress(0.6 + 0.35 * share, "time steps");
        compute(mesh, bed, on_wall, dye, share, fields);
        writer.add_step(share, 0, 0,
                        std::vector<store::ArrayValues>{
                            {velocity, fields.velocity}, {vorticity, fields.vorticity}, {tracer, fields.tracer}});
    }
    progress(0.95, "flushing to the disk");
    writer.finish();
    progress(1, "done");
}

} // namespace server::demo
