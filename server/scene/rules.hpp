// Rules of a scene that concern several members. Rules about one member are in its schema.
#pragma once

#include "scene/scene.hpp"

namespace server::scene {

inline constexpr std::size_t most_clip_planes = 6; // visible clip layers; every OpenGL has at least 8 clip planes

struct Plane {
    Vec3 origin{}, normal{}; // the normal has length 1
};

// A clip layer's normal points to the removed side. REQUIRES: apply_rules has accepted the layer's scene.
[[nodiscard]] Plane plane_of(const SliceLayer& slice);
[[nodiscard]] Plane plane_of(const ClipLayer& clip);

// Throws Invalid if the document has the former member /legend; the error names its successor, annotations.legend. Call
// this before the schema check, whose error would not name the successor.
void refuse_old_legend(const nlohmann::json& document);

// Sorts the layers by (order, id). Removes edges, contours and thresholds that are switched off. Contours without
// values get a count. Throws Invalid.
void apply_rules(Scene& scene);

} // namespace server::scene
