// WrittenPoints: the positions of a mesh on the disk. The file is mapped, and its checksum is not checked.
#pragma once

#include "ciel/face_mesh.hpp"
#include "store/cache/mapped_file.hpp"
#include "store/format/attributes.hpp"
#include "store/format/layout.hpp"

#include <filesystem>

namespace server::store {

// Only for a dataset that this process writes or has locked: no other process changes its files meanwhile.
class WrittenPoints {
public:
    WrittenPoints(const std::filesystem::path& mesh, const MeshAttributes& attributes, std::size_t coordinates)
        : origin_(attributes.origin), double_positions_(attributes.info.double_positions),
          positions_(layout::chunk(mesh / "positions", coordinates, 3),
                     3 * attributes.info.vertices * (double_positions_ ? sizeof(double) : sizeof(float))) {}

    [[nodiscard]] ciel::FaceMeshView view() const { // without cells and faces
        const ciel::ValuesView positions =
            double_positions_ ? ciel::ValuesView(positions_.as<double>()) : ciel::ValuesView(positions_.as<float>());
        return ciel::face_mesh_view(origin_, positions, {}, {}, {}, {}, {});
    }

private:
    ciel::Vec3d origin_;
    bool double_positions_;
    MappedFile positions_;
};

} // namespace server::store
