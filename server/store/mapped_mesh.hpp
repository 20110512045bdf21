// One mesh's topology, mapped and verified: what every refresh of a dataset shares.
#pragma once

#include "store/attributes.hpp"
#include "store/mapped_file.hpp"
#include "store/zarr_array.hpp"

namespace ciel::store {

class MappedMesh {
public:
    // Maps and verifies everything but positions and values: checksums, and that no index leads out of its array, so
    // that the kernel may trust them. Throws Error naming the file.
    explicit MappedMesh(std::filesystem::path directory);

    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }
    [[nodiscard]] const MeshAttributes& attributes() const { return attributes_; }
    [[nodiscard]] std::uint64_t vertex_count() const { return vertex_count_; }
    [[nodiscard]] std::uint64_t cell_count() const { return cell_types().size(); }
    [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }
    [[nodiscard]] std::span<const Index> original_vertex() const { return array("original_vertex").as<Index>(); }
    [[nodiscard]] std::span<const Index> original_cell() const { return array("original_cell").as<Index>(); }
    // The topology with these positions.
    [[nodiscard]] FaceMeshView view(std::span<const float> positions) const;
    void check_sizes() const;
    void check_intact() const;

private:
    [[nodiscard]] const MappedFile& array(const std::string& name) const { return arrays_.at(name); }
    [[nodiscard]] std::span<const std::uint8_t> cell_types() const { return array("cell_types").as<std::uint8_t>(); }
    void map(const std::string& name, ElementType type);
    void verify_checksums() const;
    void verify_indices() const;

    std::filesystem::path directory_;
    MeshAttributes attributes_;
    std::uint64_t vertex_count_ = 0;
    std::map<std::string, MappedFile> arrays_; // by name; groups as "groups/<index>"
    std::vector<Group> groups_;
};

} // namespace ciel::store
