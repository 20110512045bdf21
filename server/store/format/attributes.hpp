// Reads and writes the .zattrs documents of a dataset, of a mesh, of a group and of an array of values.
#pragma once

#include "store/format/dataset_info.hpp"

#include <filesystem>
#include <string_view>

namespace server::store {

inline constexpr std::size_t most_components = 64; // of an array of values

[[nodiscard]] DatasetInfo parse_root_attributes(std::string_view text, const std::filesystem::path& file);
[[nodiscard]] std::string root_attributes_text(const DatasetInfo& info);

struct GroupName {
    Group::Of of = Group::Of::faces;
    std::string name;
    PatchFacts facts = {};
};

struct MeshAttributes {
    ciel::Vec3d origin{};
    MeshInfo info;
    std::vector<GroupName> groups;
    // Checksum by name of the topology array. Groups have checksums, too, by the name "groups/<index>".
    std::map<std::string, std::string> checksums;
    // One checksum for each coordinate set, by index. Sets that were added last with plain Zarr have no entry.
    std::vector<std::string> coordinate_checksums;
};
[[nodiscard]] MeshAttributes parse_mesh_attributes(std::string_view text, const std::filesystem::path& file);
[[nodiscard]] std::string to_text(const MeshAttributes& mesh);

[[nodiscard]] ArrayInfo parse_array_attributes(std::string_view text, const std::filesystem::path& file);
[[nodiscard]] std::string to_text(const ArrayInfo& array);
[[nodiscard]] std::string group_attributes_text(const GroupName& group);

} // namespace server::store
