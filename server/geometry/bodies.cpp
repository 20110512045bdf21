#include "geometry/bodies.hpp"

#include "store/mesh_questions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace server::geometry {
namespace {

constexpr double margin_of_side = 0.01;      // tolerance at a side, as a fraction of the domain's extent
constexpr double finer_than_sides = 1.0 / 3; // limit for the edge length of a body's faces, relative to flat sides
constexpr double most_of_boundary = 2.0 / 3; // a patch with a larger share is the wall of a pipe or channel
constexpr std::array<std::string_view, 18> no_walls{
    "inlet",  "outlet",   "inflow",    "outflow",   "farfield", "far-field", "far_field", "freestream", "symm",
    "cyclic", "periodic", "interface", "processor", "overset",  "opening",   "empty",     "interior",   "internal"};

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return text;
}

// A sliding interface has a name such as "ami1". If a letter follows "ami", the name is a different word.
bool is_sliding(const std::string& name) {
    return name.starts_with("ami") && (name.size() == 3 || !('a' <= name[3] && name[3] <= 'z'));
}

bool has_wall_type(const MeasuredPatch& patch) { return patch.type == "wall" || patch.type == "mappedWall"; }

bool is_wall_by_name(const MeasuredPatch& patch) {
    const std::string name = lower_case(patch.name);
    return !is_sliding(name) &&
           std::ranges::none_of(no_walls, [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

double margin_along(const BoundingBox& domain, std::size_t axis) {
    return margin_of_side * (domain.high[axis] - domain.low[axis]);
}

bool is_inside(const MeasuredPatch& patch, const BoundingBox& domain) {
    int inside = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double margin = margin_along(domain, axis);
        inside += patch.box.low[axis] > domain.low[axis] + margin && patch.box.high[axis] < domain.high[axis] - margin;
    }
    return inside >= 2;
}

bool is_flat_side(const MeasuredPatch& patch, const BoundingBox& domain) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double margin = margin_along(domain, axis);
        if (patch.box.high[axis] < domain.low[axis] + margin || patch.box.low[axis] > domain.high[axis] - margin)
            return true;
    }
    return false;
}

double length_of_faces(const MeasuredPatch& patch) { return std::sqrt(patch.area / static_cast<double>(patch.faces)); }

} // namespace

std::vector<MeasuredPatch> patches_of(const store::Dataset& dataset, const store::Step& step) {
    std::vector<MeasuredPatch> patches;
    for (const store::Group& group : dataset.groups(step.mesh)) {
        if (group.of != store::Group::Of::faces || group.ids.empty()) continue;
        const ciel::FacesSize size = store::size_of_faces(dataset, step, group);
        patches.push_back({group.name, {size.low, size.high}, size.area, group.ids.size(), group.facts.type});
    }
    return patches;
}

std::vector<MeasuredPatch> bodies_of(std::span<const MeasuredPatch> patches, const BoundingBox& domain) {
    double whole = 0, of_sides = 0;
    std::size_t faces_of_sides = 0;
    for (const MeasuredPatch& patch : patches) {
        whole += patch.area;
        if (!is_flat_side(patch, domain)) continue;
        of_sides += patch.area;
        faces_of_sides += patch.faces;
    }
    const double length_of_sides = faces_of_sides == 0 ? 0 : std::sqrt(of_sides / static_cast<double>(faces_of_sides));
    const bool types_tell = std::ranges::any_of(patches, has_wall_type);
    std::vector<MeasuredPatch> bodies;
    std::ranges::copy_if(patches, std::back_inserter(bodies), [&](const MeasuredPatch& patch) {
        if (!(types_tell ? has_wall_type(patch) : is_wall_by_name(patch))) return false;
        return is_inside(patch, domain) ||
               (!is_flat_side(patch, domain) && length_of_faces(patch) < finer_than_sides * length_of_sides &&
                patch.area < most_of_boundary * whole);
    });
    return bodies;
}

BoundingBox box_around(std::span<const MeasuredPatch> patches) {
    BoundingBox box = patches.front().box;
    for (const MeasuredPatch& patch : patches)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box.low[axis] = std::min(box.low[axis], patch.box.low[axis]);
            box.high[axis] = std::max(box.high[axis], patch.box.high[axis]);
        }
    return box;
}

} // namespace server::geometry
