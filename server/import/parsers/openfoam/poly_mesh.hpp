// The files of an OpenFOAM mesh, constant/polyMesh (OpenFOAM User Guide, "Mesh description"). Each function takes the
// bytes of one file and throws Error naming `file` where they are not what the format asks for. Labels come as they are
// written: whether they name what is there is the caller's to check.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::importer {

// `points`: x, y, z of each point, in the digits that the file has.
[[nodiscard]] std::vector<double> parse_foam_points(std::string_view bytes, const std::string& file);

// `faces`, as faceList or faceCompactList.
struct FoamFaces {
    std::vector<std::size_t> offset{0}; // face -> where its points begin; one more than there are faces
    std::vector<std::int64_t> points;
};
[[nodiscard]] FoamFaces parse_foam_faces(std::string_view bytes, const std::string& file);

// `owner`, `neighbour`, `cellProcAddressing`: one list, of at most `most` labels.
[[nodiscard]] std::vector<std::int64_t> parse_foam_labels(std::string_view bytes, const std::string& file,
                                                          std::size_t most);

// `boundary`: patches in order. On a processor patch, `neighbour` is the other processor.
struct FoamPatch {
    std::string name, type;
    std::vector<std::string> groups;
    std::int64_t first_face = 0, face_count = 0;
    std::int64_t neighbour = -1;
};
[[nodiscard]] std::vector<FoamPatch> parse_foam_boundary(std::string_view bytes, const std::string& file);

// `cellZones`, `faceZones`: labels of cells or faces under a name.
struct FoamZone {
    std::string name;
    std::vector<std::int64_t> labels;
};
[[nodiscard]] std::vector<FoamZone> parse_foam_zones(std::string_view bytes, const std::string& file);

} // namespace ciel::importer
