#include "import/patches.hpp"

#include "import/corner_index.hpp"

#include <numeric>

namespace ciel::importer {

namespace {

// Two surfaces may name the same face. Of coincident ones (both sides of a baffle) each is claimed in turn.
class BoundaryFaces {
public:
    explicit BoundaryFaces(const FaceMeshView& mesh) : corners_(mesh) {
        for (Index face = 0; face < mesh.face_count(); ++face)
            if (mesh.neighbour[face] == none)
                faces_[corners_.learn(mesh.loop(face).unchecked())].push_back({face, 0, none});
    }

    // The face with these corners that this surface has not claimed, or none.
    Index claim(vtkDataSet* data, vtkIdType cell, Index surface) {
        const auto found = faces_.find(corners_.find(data, cell));
        if (found == faces_.end()) return none;
        Candidate* best = nullptr;
        for (Candidate& candidate : found->second)
            if (candidate.last_surface != surface && (best == nullptr || candidate.claims < best->claims))
                best = &candidate;
        if (best == nullptr) return none;
        best->last_surface = surface;
        ++best->claims;
        return best->face;
    }

private:
    struct Candidate {
        Index face;
        Index claims;
        Index last_surface;
    };
    CornerIndex corners_;
    std::unordered_map<Corners, std::vector<Candidate>, CornersHash> faces_;
};

void add_patch(BoundaryFaces& boundary, Patch patch, vtkDataSet* data, std::span<const vtkIdType> cells,
               std::vector<Patch>& patches) {
    for (const vtkIdType cell : cells) {
        const Index face = boundary.claim(data, cell, static_cast<Index>(patches.size()));
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
        const std::size_t source = surfaces[i].own_values ? i : Patch::none_of_them;
        add_patch(boundary, {surfaces[i].name, source, {}, {}, 0}, surfaces[i].data, cells, patches);
    }
    for (const JoinedMesh::Surface& surface : joined.surfaces) {
        const JoinedMesh::Part& part = joined.parts[surface.part];
        add_patch(boundary, {part.name + " surface", Patch::none_of_them, {}, {}, 0}, part.data, surface.cells,
                  patches);
    }
    return patches;
}

} // namespace ciel::importer
