// Cells and faces found again by where their corners are, whatever the ids and the order of their points.
#pragma once

#include "ciel/face_mesh.hpp"

#include <array>
#include <unordered_map>
#include <vector>
#include <vtkDataSet.h>
#include <vtkIdList.h>
#include <vtkNew.h>

namespace ciel::importer {

using Corners = std::vector<Index>; // one vertex for each place, sorted, distinct

[[nodiscard]] Corners normalised(Corners corners); // sorted, distinct

struct CornersHash {
    std::size_t operator()(const Corners& corners) const;
};

class CornerIndex {
public:
    explicit CornerIndex(const FaceMeshView& mesh) : mesh_(mesh) {}

    // Of stored vertices; their places are known from then on.
    [[nodiscard]] Corners learn(std::span<const Index> vertices);
    // Of a cell of the input. Points where no learnt vertex is (mid-side nodes) do not count; empty when too few are
    // left.
    [[nodiscard]] Corners find(vtkDataSet* data, vtkIdType cell);

private:
    using Place = std::array<std::uint32_t, 3>; // the bits of a float position
    struct PlaceHash {
        std::size_t operator()(const Place& place) const;
    };
    static Place place_of(const float* position);

    FaceMeshView mesh_;
    std::unordered_map<Place, Index, PlaceHash> vertices_; // place -> the vertex learnt there first
    vtkNew<vtkIdList> ids_;
};

} // namespace ciel::importer
