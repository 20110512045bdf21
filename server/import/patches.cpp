#include "import/patches.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <unordered_map>
#include <vtkIdList.h>
#include <vtkNew.h>

namespace ciel::importer {

namespace {

using Corners = std::vector<Index>; // canonical vertices, sorted, distinct

struct Hash {
    std::size_t operator()(const std::array<std::uint32_t, 3>& bits) const { return mix(bits); }
    std::size_t operator()(const Corners& corners) const { return mix(corners); }

    template <typename Words>
    static std::size_t mix(const Words& words) {
        std::uint64_t hash = 0x9E3779B97F4A7C15U;
        for (const std::uint32_t word : words) {
            hash = (hash ^ word) * 0xBF58476D1CE4E5B9U;
            hash ^= hash >> 29;
        }
        return hash;
    }
};

class BoundaryFaces {
public:
    explicit BoundaryFaces(const FaceMeshView& mesh) : mesh_(mesh) {
        for (Index face = 0; face < mesh.face_count(); ++face)
            if (mesh.neighbour[face] == none) faces_[corners_of(mesh.loop(face))].push_back(face);
        for (auto& [corners, faces] : faces_) std::reverse(faces.begin(), faces.end()); // claimed from the back
    }

    // The face with these corners, or none. Coincident faces (both sides of a baffle) are claimed in turn.
    Index claim(vtkDataSet* data, vtkIdType cell) {
        data->GetCellPoints(cell, ids_);
        Corners corners;
        for (vtkIdType i = 0; i < ids_->GetNumberOfIds(); ++i) {
            std::array<double, 3> point{};
            data->GetPoint(ids_->GetId(i), point.data());
            std::array<float, 3> offset{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                offset[axis] = static_cast<float>(point[axis] - mesh_.origin[axis]);
            const auto known = vertices_.find(key(offset.data()));
            if (known == vertices_.end()) return none;
            corners.push_back(known->second);
        }
        const auto found = faces_.find(normalised(std::move(corners)));
        if (found == faces_.end() || found->second.empty()) return none;
        const Index face = found->second.back();
        found->second.pop_back();
        return face;
    }

private:
    static std::array<std::uint32_t, 3> key(const float* point) {
        std::array<std::uint32_t, 3> bits{};
        for (std::size_t axis = 0; axis < 3; ++axis) bits[axis] = std::bit_cast<std::uint32_t>(point[axis] + 0.0F);
        return bits; // adding zero makes one of the two zeros
    }

    static Corners normalised(Corners corners) {
        std::sort(corners.begin(), corners.end());
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        return corners;
    }

    Corners corners_of(std::span<const Index> loop) {
        Corners corners;
        for (const Index vertex : loop)
            corners.push_back(
                vertices_.try_emplace(key(&mesh_.positions[3 * std::size_t{vertex}]), vertex).first->second);
        return normalised(std::move(corners));
    }

    FaceMeshView mesh_;
    std::unordered_map<std::array<std::uint32_t, 3>, Index, Hash> vertices_; // position -> canonical vertex
    std::unordered_map<Corners, std::vector<Index>, Hash> faces_;
    vtkNew<vtkIdList> ids_;
};

void add_patch(BoundaryFaces& boundary, Patch patch, vtkDataSet* data, std::span<const vtkIdType> cells,
               std::vector<Patch>& patches) {
    for (const vtkIdType cell : cells) {
        const Index face = boundary.claim(data, cell);
        if (face == none) {
            ++patch.unmatched;
            continue;
        }
        patch.faces.push_back(face);
        patch.cells.push_back(static_cast<std::size_t>(cell));
    }
    patches.push_back(std::move(patch));
}

} // namespace

std::vector<Patch> match_patches(const FaceMeshView& mesh, const JoinedMesh& joined,
                                 const std::vector<Block>& surfaces) {
    std::vector<Patch> patches;
    if (surfaces.empty() && joined.surfaces.empty()) return patches;
    BoundaryFaces boundary(mesh);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        std::vector<vtkIdType> cells(static_cast<std::size_t>(surfaces[i].data->GetNumberOfCells()));
        std::iota(cells.begin(), cells.end(), vtkIdType{0});
        add_patch(boundary, {surfaces[i].name, i, {}, {}, 0}, surfaces[i].data, cells, patches);
    }
    for (const JoinedMesh::Surface& surface : joined.surfaces) {
        const JoinedMesh::Part& part = joined.parts[surface.part];
        add_patch(boundary, {part.name + " surface", Patch::none_of_them, {}, {}, 0}, part.data, surface.cells,
                  patches);
    }
    return patches;
}

} // namespace ciel::importer
