// SlabTriangles: a slice of a volume, or its boundary, as triangles (paper, sections 2 and 3). The volume is divided
// into parallel slabs, and a slice is the cut by the middle plane of a slab. The property is the scalar that is drawn.
// With the value and the gradient at each vertex, a renderer can evaluate the property along any ray through the slab,
// and look up its color in a TransferTable.
#pragma once

#include "ciel/types.hpp"

#include <array>
#include <vector>

namespace server::color {

struct SlabVertex {
    ciel::Vec3f position; // offset from the mesh's surface_origin
    float value;          // value of the property
    ciel::Vec3f gradient; // gradient of the property, per unit of length
    // [min, max] of the property in the cell of the polygon whose triangles all start at this vertex. Unused if no
    // polygon's triangles start at this vertex.
    std::array<float, 2> limits;
};

// Polygons as triangle fans. All triangles of a polygon start at the same vertex, which has the limits of the polygon's
// cell. Different polygons start at different vertices.
struct SlabTriangles {
    std::vector<SlabVertex> vertices;
    std::vector<ciel::Index> triangles; // three indices in `vertices` for each triangle

    [[nodiscard]] std::size_t memory_bytes() const {
        return vertices.capacity() * sizeof(SlabVertex) + triangles.capacity() * sizeof(ciel::Index);
    }
};

} // namespace server::color
