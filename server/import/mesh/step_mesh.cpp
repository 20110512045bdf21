#include "import/mesh/step_mesh.hpp"

#include "import/mesh/degenerate_cells.hpp"
#include "import/mesh/face_pyramids.hpp"
#include "import/mesh/zones.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

namespace server::importer {

namespace {

std::string plural(std::uint64_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

const char* reason_text(ciel::BadCells::Reason reason) {
    using Reason = ciel::BadCells::Reason;
    static const std::map<Reason, const char*> texts{
        {Reason::open, "not closed"},
        {Reason::inconsistent_winding, "faces that cannot be wound consistently"},
        {Reason::inside_out_unresolved, "inside and outside that cannot be distinguished"},
        {Reason::index_out_of_range, "a vertex that does not exist"},
        {Reason::too_few_faces, "too few faces"},
        {Reason::repeated, "the same faces as an earlier cell, which was kept"},
    };
    return texts.at(reason);
}

std::string id_list(const std::vector<ciel::Index>& ids, const std::vector<ciel::Index>& source_cell) {
    std::string text;
    for (const ciel::Index id : ids) text += (text.empty() ? "" : ", ") + std::to_string(source_cell[id]);
    return text;
}

bool has_pieces(const JoinedMesh& joined) {
    return std::any_of(joined.members.begin(), joined.members.end(),
                       [](const auto& member) { return member.whole >= 0; });
}

void describe_assembly(const JoinedMesh& joined, const ciel::AssembleReport& report, StepMesh& mesh) {
    for (const ciel::BadCells& bad : report.bad_cells) {
        const bool is_in_two_pieces = bad.reason == ciel::BadCells::Reason::repeated && has_pieces(joined);
        mesh.bad_cells += is_in_two_pieces ? 0 : bad.count; // a cell repeated in two pieces is a ghost cell
        mesh.notes.push_back(plural(bad.count, "cell was", "cells were") + " left out: " + reason_text(bad.reason) +
                             " (first ids: " + id_list(bad.first_ids, joined.source_cell) + ").");
    }
    if (report.short_faces > 0)
        mesh.notes.push_back(plural(report.short_faces, "face", "faces") + " of fewer than three corners " +
                             (report.short_faces == 1 ? "was" : "were") +
                             " left out (first cells: " + id_list(report.first_short, joined.source_cell) + ").");
    if (report.reversed_cells > 0)
        mesh.notes.push_back(plural(report.reversed_cells, "cell was", "cells were") + " wound inwards and turned.");
    if (report.reversed_faces > 0)
        mesh.notes.push_back(plural(report.reversed_faces, "face was", "faces were") +
                             " turned to agree with the cell.");
    if (report.internal_boundaries > 0)
        mesh.notes.push_back(plural(report.internal_boundaries, "face belongs to three or more cells and stays",
                                    "faces belong to three or more cells and stay") +
                             " internal boundary.");
    if (report.inverted_cells > 0)
        mesh.notes.push_back(
            plural(report.inverted_cells, "cell has negative volume and was", "cells have negative volume and were") +
            " kept (first ids: " + id_list(report.first_inverted, joined.source_cell) + ").");
}

void describe_joining(const JoinedMesh& joined, StepMesh& mesh) {
    if (joined.members.size() > 1)
        mesh.notes.push_back(std::to_string(joined.members.size()) +
                             (has_pieces(joined) ? " pieces or blocks were joined" : " blocks were joined") +
                             "; vertex and cell ids continue from one to the next.");
    for (const auto& [what, count] : joined.reduced_cells)
        mesh.notes.push_back(std::to_string(count) + " " + what + " keep their corners; mid-side nodes were dropped.");
    if (joined.blanked_cells > 0)
        mesh.notes.push_back(plural(joined.blanked_cells, "cell is", "cells are") +
                             " blanked or ghosts, and left out.");
    if (joined.convex_point_sets > 0)
        mesh.notes.push_back(plural(joined.convex_point_sets, "convex point set was", "convex point sets were") +
                             " left out, because convex point sets have no faces; write them as polyhedra.");
    if (joined.ignored_cells > 0)
        mesh.notes.push_back(plural(joined.ignored_cells, "cell", "cells") +
                             " without volume or surface were ignored.");
}

void describe_shapes(const JoinedMesh& joined, StepMesh& mesh) {
    constexpr std::size_t shown = 10;
    const InvertedPyramids inverted = find_inverted_pyramids(mesh.cells->matched, mesh.view());
    if (inverted.count == 0) return;
    std::vector<ciel::Index> ids;
    for (const ciel::Index cell : inverted.cells) ids.push_back(mesh.cells->matched.original_cell()[cell]);
    std::sort(ids.begin(), ids.end());
    ids.resize(std::min(ids.size(), shown));
    mesh.notes.push_back(plural(inverted.count, "face looks", "faces look") + " inwards from the center of " +
                         plural(inverted.cells.size(), "cell", "cells") +
                         " (inverted face pyramids), which were kept (first ids: " + id_list(ids, joined.source_cell) +
                         ").");
}

void name_patches(const std::vector<InputGrid>& surfaces, StepMesh& mesh) {
    for (const Patch& patch : mesh.patches) {
        if (patch.unmatched > 0)
            mesh.notes.push_back(plural(patch.unmatched, "face", "faces") + " of surface \"" + patch.name +
                                 "\" are not boundary faces of the mesh and were ignored.");
        if (patch.faces.empty()) continue;
        std::vector<ciel::Index> faces = patch.faces;
        std::sort(faces.begin(), faces.end());
        const bool is_known = patch.surface < surfaces.size();
        store::PatchFacts facts = is_known ? surfaces[patch.surface].facts : store::PatchFacts{};
        mesh.groups.push_back({store::Group::Of::faces, patch.name, std::move(faces), std::move(facts)});
    }
}

// A zone has the cells of all members with its name. If all members have the same name, makes no zone.
void name_members(const JoinedMesh& joined, StepMesh& mesh) {
    std::map<std::string, std::vector<ciel::Index>> ids;
    std::vector<std::string> names; // in order of first use
    const std::span<const ciel::Index> original = mesh.cells->matched.original_cell();
    std::vector<ciel::Index> stored(joined.cell_types.size(), ciel::none);
    for (ciel::Index cell = 0; cell < original.size(); ++cell) stored[original[cell]] = cell;
    for (const JoinedMesh::Member& member : joined.members) {
        const auto [zone, is_new] = ids.try_emplace(member.name);
        if (is_new) names.push_back(member.name);
        for (ciel::Index cell = member.mesh_cell_begin; cell < member.mesh_cell_end; ++cell)
            if (stored[cell] != ciel::none) zone->second.push_back(stored[cell]);
    }
    if (names.size() < 2) return;
    for (const std::string& name : names) {
        std::sort(ids[name].begin(), ids[name].end());
        if (!ids[name].empty()) mesh.groups.push_back({store::Group::Of::cells, name, std::move(ids[name])});
    }
}

void name_zones(const std::vector<Zone>& zones, StepMesh& mesh) {
    for (const Zone& zone : zones) {
        if (zone.unmatched > 0)
            mesh.notes.push_back(plural(zone.unmatched, "cell", "cells") + " of zone \"" + zone.name +
                                 "\" are not in the mesh and were ignored.");
        if (!zone.cells.empty()) mesh.groups.push_back({store::Group::Of::cells, zone.name, zone.cells});
    }
}

// Ghost, blanked and bad cells are not in the mesh, so they count as unmatched.
void name_cells(const JoinedMesh& joined, const std::vector<NamedCells>& zones, StepMesh& mesh) {
    if (zones.empty()) return;
    std::vector<Zone> found;
    std::unordered_map<ciel::Index, ciel::Index> stored; // running cell -> cell of the assembled mesh
    const std::span<const ciel::Index> original = mesh.cells->matched.original_cell();
    for (ciel::Index cell = 0; cell < original.size(); ++cell) stored.emplace(joined.source_cell[original[cell]], cell);
    for (const NamedCells& named : zones) {
        Zone zone{named.name, {}, 0};
        for (const ciel::Index cell : named.cells) {
            const auto at = stored.find(cell);
            if (at == stored.end())
                ++zone.unmatched;
            else
                zone.cells.push_back(at->second);
        }
        std::sort(zone.cells.begin(), zone.cells.end());
        zone.cells.erase(std::unique(zone.cells.begin(), zone.cells.end()), zone.cells.end());
        found.push_back(std::move(zone));
    }
    name_zones(found, mesh);
}

PieceJoins find_cuts(const std::shared_ptr<const JoinedMesh>& joined, const InputGrids& input_grids) {
    if (has_pieces(*joined)) return find_cut_between_pieces(ciel::MatchedCells(joined->view(), joined), *joined);
    return {input_grids.same_points, input_grids.joined_faces, input_grids.single_faces, 0};
}

template <class T>
std::vector<T> reordered(std::span<const T> running, std::span<const ciel::Index> stored_to_running,
                         std::size_t width) {
    std::vector<T> stored(stored_to_running.size() * width);
    for (std::size_t i = 0; i < stored_to_running.size(); ++i)
        std::copy_n(running.begin() + static_cast<std::ptrdiff_t>(stored_to_running[i] * width), width,
                    stored.begin() + static_cast<std::ptrdiff_t>(i * width));
    return stored;
}

void find_cells(std::shared_ptr<const JoinedMesh> joined, StepMesh& mesh) {
    mesh.cells = std::make_unique<NewCells>(std::move(joined));
    const ciel::MatchedCells& matched = mesh.cells->matched;
    describe_assembly(*mesh.cells->joined, matched.report(), mesh);
    if (matched.original_cell().empty())
        throw ciel::Error("none of its " + std::to_string(mesh.input_cells) +
                          " cells can be used: " + reason_text(matched.report().bad_cells.at(0).reason));
    mesh.boundary = matched.boundary();
    if (mesh.boundary.double_positions.empty())
        mesh.positions = store::Values(std::exchange(mesh.boundary.positions, {}));
    else
        mesh.positions = store::Values(std::exchange(mesh.boundary.double_positions, {}));
    mesh.point_of_vertex.assign(matched.original_vertex().begin(), matched.original_vertex().end());
    mesh.cell_of_cell.reserve(matched.original_cell().size());
    for (const ciel::Index cell : matched.original_cell())
        mesh.cell_of_cell.push_back(mesh.cells->joined->source_cell[cell]);
}

void name_groups(const InputGrids& input_grids, const std::vector<ciel::Index>& representative, StepMesh& mesh) {
    const JoinedMesh& joined = *mesh.cells->joined;
    mesh.patches = match_patches(mesh.view(), mesh.point_of_vertex, joined, representative, input_grids.surfaces);
    name_patches(input_grids.surfaces, mesh);
    name_members(joined, mesh);
    name_zones(match_zones(mesh.cells->matched, mesh.view(), input_grids.zones), mesh);
    name_cells(joined, input_grids.named_cells, mesh);
}

} // namespace

StepMesh build_step_mesh(const InputGrids& input_grids, Weld weld, const SeamDifference& difference,
                         const std::filesystem::path& folder) {
    require_volumes(input_grids);
    const auto owner = std::make_shared<JoinedMesh>(join_input_grids(input_grids.volumes, folder));
    JoinedMesh& joined = *owner;
    if (joined.cell_types.empty() && joined.convex_point_sets > 0)
        throw ciel::Error("holds only convex point sets, cells without faces; write them as polyhedra");
    if (joined.cell_types.empty()) throw ciel::Error("holds no volume cells");

    StepMesh mesh;
    mesh.input_vertices = joined.point_count;
    mesh.input_cells = joined.cell_types.size() + joined.convex_point_sets;
    mesh.bad_cells = joined.convex_point_sets;
    mesh.input_edges = count_edges(joined);
    mesh.point_count = joined.point_count;
    describe_joining(joined, mesh);
    for (std::string& sentence : degenerate_cells(joined)) mesh.notes.push_back(std::move(sentence));

    const PieceJoins cut = weld == Weld::seams ? find_cuts(owner, input_grids) : PieceJoins{};
    Welds welds = find_welds(joined, weld, cut, difference);
    if (has_pieces(joined)) mesh.joined_pieces = cut.points;
    if (weld == Weld::none && (!input_grids.same_points.empty() || has_pieces(joined)))
        mesh.notes.emplace_back("The pieces of the mesh were not welded (--no-weld).");
    mesh.may_be_stored_mesh = welds.representative.empty() && joined.flat_cells.empty() && !has_pieces(joined);
    mesh.seams = std::move(welds.seams);
    mesh.notes.insert(mesh.notes.end(), welds.notes.begin(), welds.notes.end());
    if (!welds.representative.empty())
        JoinedMesh::for_vertices(joined, [&](ciel::Index& vertex) { vertex = welds.representative[vertex]; });

    find_cells(owner, mesh);
    name_groups(input_grids, welds.representative, mesh);
    describe_shapes(joined, mesh);
    mesh.members = joined.members;
    return mesh;
}

void update_step_mesh(StepMesh& mesh, const InputGrids& input_grids, bool moved) {
    for (std::size_t i = 0; i < mesh.members.size(); ++i) mesh.members[i].data = input_grids.volumes[i].data;
    if (!moved) return;
    point_positions(mesh.members, mesh.point_count).with([&](auto running) {
        mesh.positions = store::Values(reordered(running, mesh.point_of_vertex, 3));
    });
}

store::Values to_stored(ciel::ValuesView running, std::span<const ciel::Index> stored_to_running, int components) {
    return running.with([&](auto all) {
        return store::Values(reordered(all, stored_to_running, static_cast<std::size_t>(components)));
    });
}

std::vector<std::int64_t> to_stored(std::span<const std::int64_t> running,
                                    std::span<const ciel::Index> stored_to_running) {
    std::vector<std::int64_t> stored;
    if (running.empty()) return stored;
    stored.reserve(stored_to_running.size());
    for (const ciel::Index item : stored_to_running) stored.push_back(running[item]);
    return stored;
}

} // namespace server::importer
