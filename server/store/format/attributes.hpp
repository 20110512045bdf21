// Reads and writes the .zattrs documents of a dataset, of a mesh, of a group and of an array of values.
#pragma once

#include "store/format/dataset_info.hpp"

#include <filesystem>
#include <string_view>

namespace ciel::store {

// Attributes of the whole dataset: format_version, id, source, created, length_units, input counts, notes.
[[nodiscard]] DatasetInfo parse_root_attributes(std::string_view text, const std::filesystem::path& file);
[[nodiscard]] std::string root_attributes_text(const DatasetInfo& info);

struct GroupName {
    Group::Of of = Group::Of::faces;
    std::string name;
    PatchFacts facts = {};
};

struct MeshAttributes {
    Vec3d origin{};
    MeshInfo info;
    std::vector<GroupName> groups;
    std::map<std::string, std::string> checksums;  // by name of the topology array; groups as "groups/<index>"
    std::vector<std::string> coordinate_checksums; // of the first coordinate sets; sets added with plain Zarr have none
};
[[nodiscard]] MeshAttributes parse_mesh_attributes(std::string_view text, const std::filesystem::path& file);
[[nodiscard]] std::string to_text(const MeshAttributes& mesh);

[[nodiscard]] ArrayInfo parse_array_attributes(std::string_view text, const std::filesystem::path& file);
[[nodiscard]] std::string to_text(const ArrayInfo& array);
[[nodiscard]] std::string group_attributes_text(const GroupName& group);

} // namespace ciel::store
