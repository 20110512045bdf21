// Parses the files of an OpenFOAM mesh, constant/polyMesh (OpenFOAM User Guide, "Mesh description"). The functions
// throw Error if the bytes violate the format. The caller must check that labels are within range.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace server::importer {

// Returns x, y, z of each point.
[[nodiscard]] std::vector<double> parse_foam_points(std::string_view bytes, const std::string& file);

// The content of a faceList or a faceCompactList.
struct FoamFaces {
    std::vector<std::size_t> offset{0}; // face -> index of its first point in `points`; the last entry is points.size()
    std::vector<std::int64_t> points;
};
[[nodiscard]] FoamFaces parse_foam_faces(std::string_view bytes, const std::string& file);

// Parses the file `owner`, `neighbour` or `cellProcAddressing`. `most`: largest number of labels.
[[nodiscard]] std::vector<std::int64_t> parse_foam_labels(std::string_view bytes, const std::string& file,
                                                          std::size_t most);

// `neighbour`: for a processor patch, the number of the processor on the other side; -1 for other patches.
struct FoamPatch {
    std::string name, type;
    std::vector<std::string> groups;
    std::int64_t first_face = 0, face_count = 0;
    std::int64_t neighbour = -1;
};
[[nodiscard]] std::vector<FoamPatch> parse_foam_boundary(std::string_view bytes, const std::string& file);

struct FoamZone {
    std::string name;
    std::vector<std::int64_t> labels;
};
[[nodiscard]] std::vector<FoamZone> parse_foam_zones(std::string_view bytes, const std::string& file);

} // namespace server::importer
