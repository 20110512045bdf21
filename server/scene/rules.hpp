// Rules of a scene that concern several members. Rules about one member are in its schema.
#pragma once

#include "scene/scene.hpp"

namespace ciel::scene {

inline constexpr std::size_t most_clip_planes = 6; // visible clip layers; every OpenGL has at least 8 clip planes

struct Plane {
    Vec3 origin{}, normal{}; // the normal has length 1
};

// Returns the plane of a layer that has axis and value, or origin and normal. A clip layer's normal points to the
// removed side. REQUIRES: apply_rules has accepted the layer's scene.
[[nodiscard]] Plane plane_of(const SliceLayer& slice);
[[nodiscard]] Plane plane_of(const ClipLayer& clip);

// Throws Invalid for a document with the member /legend, which annotations.legend has replaced. Must be called before
// the schema is checked, because the error of the schema would not name the replacement.
void refuse_old_legend(const nlohmann::json& document);

// Sorts the layers by (order, id) and removes edges, contours and thresholds that are switched off. Throws Invalid when
// the scene breaks a rule.
void apply_rules(Scene& scene);

} // namespace ciel::scene
