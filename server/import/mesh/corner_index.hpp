// Identifies cells and faces by the positions of their corners. The ids and the order of the corners do not matter.
#pragma once

#include "ciel/face_mesh.hpp"

#include <array>
#include <unordered_map>
#include <vector>
#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkNew.h>

namespace server::importer {

using Corners = std::vector<ciel::Index>; // sorted, distinct vertices of a cell or face; one vertex per position

[[nodiscard]] Corners normalised(Corners corners); // sorts and removes duplicates

struct CornersHash {
    std::size_t operator()(const Corners& corners) const;
};

class CornerIndex {
public:
    explicit CornerIndex(const ciel::FaceMeshView& mesh) : mesh_(mesh) {}

    // Registers the positions of the vertices. Returns the vertices, each replaced by the first vertex registered at
    // its position.
    [[nodiscard]] Corners learn(std::span<const ciel::Index> vertices);
    // Returns the corners of a cell of the input. Skips points without a registered vertex, for example mid-side nodes.
    // Returns an empty list if points were skipped and fewer than three corners are left.
    [[nodiscard]] Corners find(vtkDataSet* data, vtkIdType cell);

private:
    using Place = std::array<std::uint64_t, 3>; // bits of the doubles x, y, z
    struct PlaceHash {
        std::size_t operator()(const Place& place) const;
    };
    static Place place_of(const ciel::Vec3d& position);

    ciel::FaceMeshView mesh_;
    std::unordered_map<Place, ciel::Index, PlaceHash> vertices_; // position -> first vertex registered there
    vtkNew<vtkIdList> ids_;
};

} // namespace server::importer
