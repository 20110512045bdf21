// Identifies cells and faces by the positions of their corners, independent of point ids and their order.
#pragma once

#include "ciel/face_mesh.hpp"

#include <array>
#include <unordered_map>
#include <vector>
#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkNew.h>

namespace ciel::importer {

using Corners = std::vector<Index>; // vertices of a cell or face: one per position, sorted, distinct

[[nodiscard]] Corners normalised(Corners corners); // sorts and removes duplicates

struct CornersHash {
    std::size_t operator()(const Corners& corners) const;
};

class CornerIndex {
public:
    explicit CornerIndex(const FaceMeshView& mesh) : mesh_(mesh) {}

    // Registers the positions of stored vertices and returns their corners. Vertices at one position are represented by
    // the first one registered there.
    [[nodiscard]] Corners learn(std::span<const Index> vertices);
    // Returns the corners of a cell of the input. Skips points at positions that learn() has not registered (mid-side
    // nodes). Returns nothing if points were skipped and fewer than three corners are left.
    [[nodiscard]] Corners find(vtkDataSet* data, vtkIdType cell);

private:
    using Place = std::array<std::uint64_t, 3>; // bits of x, y, z
    struct PlaceHash {
        std::size_t operator()(const Place& place) const;
    };
    static Place place_of(const Vec3d& position);

    FaceMeshView mesh_;
    std::unordered_map<Place, Index, PlaceHash> vertices_; // position -> first vertex registered there
    vtkNew<vtkIdList> ids_;
};

} // namespace ciel::importer
