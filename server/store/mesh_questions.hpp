// Functions about the faces and positions of a dataset's mesh at a step. The libraries above the store use them,
// because these libraries read no face lists. The first call about faces of a mesh reads and checks its faces.
#pragma once

#include "ciel/mesh_faces.hpp"
#include "store/dataset.hpp"

namespace server::store {

// Returns the bounding box and the area of the faces of a patch.
[[nodiscard]] ciel::FacesSize size_of_faces(const Dataset& dataset, const Step& step, const Group& patch);

// Returns whether the patch has a face with all of `vertices`.
[[nodiscard]] bool has_face_with(const Dataset& dataset, const Step& step, const Group& patch,
                                 std::span<const ciel::Index> vertices);

// Returns the position of each point, in the dataset's coordinates. The positions are as precise as those of the mesh.
[[nodiscard]] std::vector<ciel::Vec3d> positions_of(const Dataset& dataset, const Step& step,
                                                    std::span<const ciel::EdgePoint> points);

// Returns the number of faces that are ambiguous for some iso-value (count_ambiguous_faces in ciel/field.hpp).
// `values`: one for each vertex.
[[nodiscard]] std::uint64_t count_ambiguous_faces(const Dataset& dataset, const Step& step, ciel::ValuesView values);

} // namespace server::store
