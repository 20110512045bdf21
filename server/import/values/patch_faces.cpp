#include "import/values/patch_faces.hpp"

#include "ciel/numbered_faces.hpp"
#include "store/no_value.hpp"

#include <algorithm>

namespace server::importer {

PatchFaces::PatchFaces(const ciel::FaceMeshView& mesh, const std::vector<Patch>& patches) : entries_(patches.size()) {
    for (ciel::Index face = 0; face < mesh.face_count(); ++face) count_ += mesh.neighbour[face] == ciel::none ? 1 : 0;
    std::vector<ciel::Index> faces; // faces of all patches, so that boundary_numbers() reads the mesh only once
    for (const Patch& patch : patches) faces.insert(faces.end(), patch.faces.begin(), patch.faces.end());
    const std::vector<ciel::Index> numbers = ciel::boundary_numbers(mesh, faces);
    auto number = numbers.begin();
    for (std::size_t patch = 0; patch < patches.size(); ++patch)
        for (const std::size_t cell : patches[patch].cells)
            if (const ciel::Index of_face = *number++; of_face != ciel::none)
                entries_[patch].push_back({of_face, cell});
}

template <class T>
std::vector<T> PatchFaces::values(const std::vector<PatchValues>& of_patches, int components) const {
    const auto has_some = [](const PatchValues& values) { return values.has_value(); };
    if (std::ranges::none_of(of_patches, has_some)) return {};
    const auto width = static_cast<std::size_t>(components);
    std::vector<T> values(count_ * width, store::no_value);
    for (std::size_t patch = 0; patch < entries_.size(); ++patch) {
        if (!of_patches[patch]) continue;
        const ciel::ValuesView own = *of_patches[patch];
        for (const Entry& entry : entries_[patch])
            for (std::size_t c = 0; c < width && (entry.cell + 1) * width <= own.size(); ++c)
                values[entry.number * width + c] = static_cast<T>(own[entry.cell * width + c]);
    }
    return values;
}

template std::vector<float> PatchFaces::values(const std::vector<PatchValues>&, int) const;
template std::vector<double> PatchFaces::values(const std::vector<PatchValues>&, int) const;

} // namespace server::importer
