// WrittenFaces: a mesh on the disk, mapped without the checks of a reader.
#pragma once

#include "ciel/face_mesh.hpp"
#include "store/cache/mapped_file.hpp"
#include "store/format/attributes.hpp"
#include "store/format/layout.hpp"

#include <filesystem>

namespace ciel::store {

// For a mesh of the dataset that a writer writes or has locked: its files cannot change meanwhile. `mesh`: its
// directory.
class WrittenFaces {
public:
    WrittenFaces(const std::filesystem::path& mesh, const MeshAttributes& attributes, std::size_t coordinates)
        : origin_(attributes.origin), double_positions_(attributes.info.double_positions),
          positions_(layout::chunk(mesh / "positions", coordinates, 3),
                     3 * attributes.info.vertices * (double_positions_ ? sizeof(double) : sizeof(float))),
          types_(whole(mesh, "cell_types")), offset_(whole(mesh, "face_offset")), vertex_(whole(mesh, "face_vertex")),
          owner_(whole(mesh, "owner")), neighbour_(whole(mesh, "neighbour")) {}

    [[nodiscard]] FaceMeshView view() const {
        const ValuesView positions =
            double_positions_ ? ValuesView(positions_.as<double>()) : ValuesView(positions_.as<float>());
        return face_mesh_view(origin_, positions, types_.as<std::uint8_t>(), offset_.as<std::uint64_t>(),
                              vertex_.as<Index>(), owner_.as<Index>(), neighbour_.as<Index>());
    }

private:
    [[nodiscard]] static MappedFile whole(const std::filesystem::path& mesh, const char* name) {
        const std::filesystem::path file = layout::chunk(mesh / name, 0, 1);
        return {file, static_cast<std::size_t>(std::filesystem::file_size(file))};
    }

    Vec3d origin_;
    bool double_positions_;
    MappedFile positions_, types_, offset_, vertex_, owner_, neighbour_;
};

} // namespace ciel::store
