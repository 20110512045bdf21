// What the solver has on the faces of patches, in the order in which a dataset keeps values of the boundary's faces.
#pragma once

#include "import/mesh/patches.hpp"
#include "import/values/wall_values.hpp"

namespace ciel::importer {

class PatchFaces {
public:
    PatchFaces(const FaceMeshView& mesh, const std::vector<Patch>& patches);

    // components values per boundary face; store::no_value where no patch has any. Empty where none has.
    [[nodiscard]] std::vector<float> values(const std::vector<PatchValues>& of_patches, int components) const;

private:
    struct Entry {
        Index number;     // of the boundary face
        std::size_t cell; // of the patch's surface
    };
    std::vector<std::vector<Entry>> entries_; // per patch
    std::size_t count_ = 0;                   // of all boundary faces
};

} // namespace ciel::importer
