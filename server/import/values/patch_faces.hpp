// The solver's values on the faces of patches, in the order of a dataset's boundary faces.
#pragma once

#include "import/mesh/patches.hpp"
#include "import/values/wall_values.hpp"

namespace server::importer {

class PatchFaces {
public:
    PatchFaces(const ciel::FaceMeshView& mesh, const std::vector<Patch>& patches);

    // Returns the values on all boundary faces. Faces without values get store::no_value. Returns an empty list if no
    // patch has values. T: float or double.
    template <class T>
    [[nodiscard]] std::vector<T> values(const std::vector<PatchValues>& of_patches, int components) const;

private:
    struct Entry {
        ciel::Index number; // index among the boundary faces
        std::size_t cell;   // cell id in the patch's surface
    };
    std::vector<std::vector<Entry>> entries_; // per patch
    std::size_t count_ = 0;                   // number of boundary faces
};

} // namespace server::importer
