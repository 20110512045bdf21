// The faces of a FaceMesh, the input of Algorithm 5 (paper, appendix A), block by block.
#pragma once

#include "mesh/cell_faces.hpp"
#include "mesh/face_source.hpp"
#include "mesh/read_once.hpp"

#include <algorithm>

namespace ciel::detail {

// The mesh may be in a mapped file that changes. Therefore each array is read once and then checked.
class FaceMeshSource final : public FaceSource {
public:
    // Throws Error when `mesh` breaks the contract of FaceMeshView. `mesh` must outlive the object.
    explicit FaceMeshSource(const FaceMeshView& mesh);

    Index vertex_count() const override { return mesh_.vertex_count(); }
    void list(Index cell_begin, Index cell_end, FaceLoops& out) const override;
    void refuse() const override { mesh_.owner.refuse(); }

    [[nodiscard]] Index cell_count() const { return mesh_.cell_count(); }
    [[nodiscard]] Index face_count() const { return mesh_.face_count(); }
    // Calls visit(number of corners, owner) for the faces of the cell. Does not check the numbers.
    template <class Visit>
    void for_faces_of(Index cell, Visit&& visit) const {
        const auto offsets = mesh_.face_offset.unchecked();
        const auto owners = mesh_.owner.unchecked();
        faces_.for_faces(cell, [&](Index face) {
            visit(static_cast<std::size_t>(offsets[face + 1] - offsets[face]), read_once(owners[face]));
        });
    }
    // Calls visit(owner, neighbour or none, vertices) for all faces.
    template <class Visit>
    void for_faces(Visit&& visit) const;

private:
    void copy_own(Index face_begin, Index face_end, FaceLoops& out) const;
    void append(Index face, FaceLoops& out) const;

    const FaceMeshView& mesh_;
    CellFaces faces_;
};

// Does not use Ids::operator[], because its checks cost time in a pass over all faces.
template <class Visit>
void FaceMeshSource::for_faces(Visit&& visit) const {
    const auto owners = mesh_.owner.unchecked(), neighbours = mesh_.neighbour.unchecked();
    const auto offsets = mesh_.face_offset.unchecked();
    const auto vertices = mesh_.face_vertex.unchecked();
    std::uint64_t at = 0;
    for (std::size_t face = 0; face < owners.size(); ++face) {
        const std::uint64_t offset = read_once(offsets[face + 1]);
        const std::uint64_t end = std::clamp<std::uint64_t>(offset, at, vertices.size());
        visit(read_once(owners[face]), read_once(neighbours[face]), vertices.subspan(at, end - at));
        at = end;
    }
}

} // namespace ciel::detail
