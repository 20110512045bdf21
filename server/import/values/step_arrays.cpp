#include "import/values/step_arrays.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>

namespace server::importer {

namespace {

// Follows the boundary condition, or the patch type if it is not known (OpenFOAM User Guide, "Boundary conditions").
PatchRole role_of(const store::PatchFacts& facts, const std::string& field) {
    constexpr std::string_view planes[] = {"slip", "symmetry", "symmetryPlane", "basicSymmetry", "partialSlip"};
    constexpr std::string_view free[] = {"zeroGradient", "fixedGradient", "inletOutlet", "fixedFluxPressure",
                                         "pressureInletOutletVelocity"};
    const auto condition = facts.conditions.find(field);
    const bool is_known = condition != facts.conditions.end() && !condition->second.empty();
    const std::string& told = is_known ? condition->second : facts.type;
    if (std::ranges::find(planes, told) != std::end(planes)) return PatchRole::plane;
    return std::ranges::find(free, told) != std::end(free) ? PatchRole::free : PatchRole::other;
}

// A patch is a no-slip wall if a vector is zero on all its faces, although it is not zero in all cells.
std::vector<bool> find_no_slip(const StepMesh& mesh, const InputGrids& input_grids,
                               const std::vector<FieldName>& fields) {
    std::vector<bool> no_slip(mesh.patches.size(), false);
    for (const FieldName& field : fields) {
        if (field.of != FieldOf::cells || field.components != 3) continue;
        if (holds_only_zero(gather_field(mesh.members, field))) continue;
        for (std::size_t i = 0; i < mesh.patches.size(); ++i) {
            if (mesh.patches[i].surface == Patch::none_of_them) continue;
            const InputGrid& surface = input_grids.surfaces[mesh.patches[i].surface];
            if (role_of(surface.facts, field.name) == PatchRole::other &&
                holds_only_zero(array_values(surface.data, field)))
                no_slip[i] = true;
        }
    }
    return no_slip;
}

std::vector<PatchValues> patch_values(const StepMesh& mesh, const InputGrids& input_grids, const FieldName& field) {
    std::vector<PatchValues> values(mesh.patches.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (mesh.patches[i].surface == Patch::none_of_them) continue;
        store::Values own = array_values(input_grids.surfaces[mesh.patches[i].surface].data, field);
        if (!own.empty()) values[i] = std::move(own);
    }
    return values;
}

std::vector<PatchRole> patch_roles(const StepMesh& mesh, const InputGrids& input_grids,
                                   const std::vector<bool>& no_slip, const std::string& field) {
    std::vector<PatchRole> roles(mesh.patches.size(), PatchRole::other);
    for (std::size_t i = 0; i < roles.size(); ++i) {
        const std::size_t surface = mesh.patches[i].surface;
        if (no_slip[i])
            roles[i] = PatchRole::no_slip_wall;
        else if (surface != Patch::none_of_them)
            roles[i] = role_of(input_grids.surfaces[surface].facts, field);
    }
    return roles;
}

} // namespace

void StepArrays::note_unknown_conditions(const StepMesh& mesh, const InputGrids& input_grids, const FieldName& field) {
    std::string names;
    for (const Patch& patch : mesh.patches) {
        if (patch.surface == Patch::none_of_them || patch.faces.empty()) continue;
        const auto& conditions = input_grids.surfaces[patch.surface].facts.conditions;
        const auto condition = conditions.find(field.name);
        if (condition != conditions.end() && condition->second.empty())
            names += (names.empty() ? "" : ", ") + patch.name;
    }
    if (!names.empty())
        notes_.insert("The files of " + field.name + " name no boundary condition on " + names +
                      ": the faces have the values of their cells.");
}

store::Origin StepArrays::origin_of(const FieldName& field) const {
    return source_.is_derived(field) ? store::Origin::derived : store::Origin::original;
}

// Returns false if the array does not have the chosen components. Gives a tensor the component order of the first step.
bool StepArrays::accept(FieldName& field, const std::string& stored) {
    const std::string components = components_text(field);
    if (components_.accept(stored, components)) {
        field.component_names = order_.try_emplace(stored, field.component_names).first->second;
        return true;
    }
    std::ostringstream sentence;
    sentence << "The array " << stored << " has " << components << " at time " << source_.times()[step_] << " and "
             << components_.chosen(stored) << " at other times: it was left out at that time.";
    lost_.insert(sentence.str());
    return false;
}

void StepArrays::send(const FieldName& field, const std::string& name, store::Association association,
                      store::Origin origin, store::Values values, const ArraySink& sink) {
    const auto units = units_.find(field.name);
    store::ArrayInfo info;
    info.name = name;
    info.association = association;
    info.components = field.components;
    if (units != units_.end()) info.units = units->second;
    info.component_names = field.component_names;
    info.source = {origin, field.type, source_.file_of(field, step_)};
    sink(info, std::move(values));
}

void StepArrays::send_cell_field(const StepMesh& mesh, const InputGrids& input_grids, FieldName field,
                                 bool point_field_exists, const TopologyOf& topology,
                                 std::unique_ptr<PointMaker>& maker, const ArraySink& sink) {
    const std::string name = stored_name(field.name);
    store::Values cells = to_stored(gather_field(mesh.members, field), mesh.cell_of_cell, field.components);
    // accept() returns false if other components were chosen, from a point array of this name at another step.
    if (!point_field_exists && selection_.wants(name, false) && accept(field, name)) {
        if (!maker)
            maker = std::make_unique<PointMaker>(PointMaker{ciel::PointInterpolation(topology(), mesh.view()),
                                                            WallValues(mesh.view(), mesh.patches),
                                                            PatchFaces(mesh.view(), mesh.patches)});
        const std::vector<PatchValues> on_patches = patch_values(mesh, input_grids, field);
        const std::vector<PatchRole> roles = patch_roles(mesh, input_grids, no_slip_, field.name);
        note_unknown_conditions(mesh, input_grids, field);
        cells.with([&]<class T>(std::span<const T> of_cells) {
            const auto points = std::make_shared<store::DiskVector<T>>(mesh.point_of_vertex.size() *
                                                                           static_cast<std::size_t>(field.components),
                                                                       T{}, store::DiskAllocator<T>(folder_));
            maker->interpolation.apply_into(of_cells, field.components, std::span<T>(*points));
            maker->walls.overlay(on_patches, roles, field.components, std::span<T>(*points));
            send(field, name, store::Association::point, store::Origin::interpolated,
                 store::Values(std::span<const T>(*points), points), sink);
            std::vector<T> faces = maker->patch_faces.values<T>(on_patches, field.components);
            if (!faces.empty())
                send(field, "patch:" + name, store::Association::boundary_face, origin_of(field),
                     store::Values(std::move(faces)), sink);
        });
    }
    send(field, "cell:" + name, store::Association::cell, origin_of(field), std::move(cells), sink);
}

std::vector<std::string> StepArrays::notes() const {
    std::vector<std::string> notes(notes_.begin(), notes_.end());
    for (std::string& sentence : loss_.notes()) notes.push_back(std::move(sentence));
    return notes;
}

void StepArrays::make(std::size_t step, const StepMesh& mesh, const InputGrids& input_grids, const TopologyOf& topology,
                      std::unique_ptr<PointMaker>& maker, const ArraySink& sink) {
    step_ = step;
    const std::vector<FieldName> fields = field_names(mesh.members);
    no_slip_ = find_no_slip(mesh, input_grids, fields);
    const auto has_points = [&](const std::string& name) {
        return std::any_of(fields.begin(), fields.end(), [&](const FieldName& field) {
            return field.of == FieldOf::points && stored_name(field.name) == name;
        });
    };
    for (std::string& sentence : left_out_arrays(mesh.members)) notes_.insert(std::move(sentence));
    for (std::string& sentence : lost_arrays(mesh.members)) lost_.insert(std::move(sentence));
    std::set<std::string> taken;
    for (FieldName field : fields) {
        const std::string name = stored_name(field.name);
        const bool cell = field.of == FieldOf::cells;
        selection_.saw(field);
        if (!selection_.wants(name, cell)) continue;
        if (!taken.insert((cell ? "cell:" : "") + name).second) {
            notes_.insert("Two arrays have the name " + name + "; the first was kept.");
            continue;
        }
        const std::string stored = (cell ? "cell:" : "") + name;
        if (!accept(field, stored)) continue;
        loss_.look_at(mesh.members, field, doubles_.try_emplace(stored, field.doubles).first->second);
        if (cell)
            send_cell_field(mesh, input_grids, field, has_points(name), topology, maker, sink);
        else
            send(field, name, store::Association::point, origin_of(field),
                 to_stored(gather_field(mesh.members, field), mesh.point_of_vertex, field.components), sink);
    }
}

} // namespace server::importer
