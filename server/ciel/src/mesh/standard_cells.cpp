// Faces of tetrahedra, hexahedra, wedges and pyramids for assemble, with corners in the order of VTK and CGNS.
#include "ciel/assemble.hpp"
#include "mesh/standard_shapes.hpp"

namespace ciel {

using detail::StandardShape;
using detail::with_shape;

void append_standard_faces(CellType type, std::span<const Index> corners, std::vector<std::uint64_t>& face_offset,
                           std::vector<Index>& face_vertex) {
    const bool known = with_shape(type, [&]<const StandardShape & shape>() {
        if (corners.size() != shape.corners)
            fail("a cell of type " + std::to_string(static_cast<int>(type)) + " has " + std::to_string(shape.corners) +
                 " corners, not " + std::to_string(corners.size()));
        for (std::size_t face = 0; face < shape.faces; ++face) {
            for (std::size_t h = shape.face_begin[face]; h < shape.face_begin[face + 1]; ++h)
                face_vertex.push_back(corners[shape.origin[h]]);
            face_offset.push_back(face_vertex.size());
        }
    });
    if (!known)
        fail("cell type " + std::to_string(static_cast<int>(type)) +
             " is not a standard cell; give the faces of the cell");
}

} // namespace ciel
