// MappedMesh: the topology arrays of one mesh, mapped and verified. All refreshes of a dataset share it.
#pragma once

#include "store/cache/mapped_file.hpp"
#include "store/format/attributes.hpp"
#include "store/format/zarr_array.hpp"

#include <mutex>

namespace ciel::store {

class MappedMesh {
public:
    MappedMesh(const MappedMesh&) = delete;
    MappedMesh& operator=(const MappedMesh&) = delete;
    // Maps the arrays of a mesh except positions and values. Verifies their checksums, and that all indices are in
    // range. Throws Error that names the file. Files may change afterwards, so views check each index that they read.
    MappedMesh(std::filesystem::path directory, AnyLost any_lost);

    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }
    [[nodiscard]] const MeshAttributes& attributes() const { return attributes_; }
    [[nodiscard]] std::uint64_t vertex_count() const { return vertex_count_; }
    [[nodiscard]] std::uint64_t cell_count() const { return cell_types().size(); }
    [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }
    [[nodiscard]] std::span<const Index> original_vertex() const { return array("original_vertex").as<Index>(); }
    [[nodiscard]] std::span<const Index> original_cell() const { return array("original_cell").as<Index>(); }
    // Ids that the solver gave to vertices and cells, -1 where it gave none; empty if the source has no such ids.
    [[nodiscard]] std::span<const std::int64_t> solver_vertex() const { return optional_array("solver_vertex"); }
    [[nodiscard]] std::span<const std::int64_t> solver_cell() const { return optional_array("solver_cell"); }
    // Returns the mesh with these positions, which are offsets from its origin.
    [[nodiscard]] FaceMeshView view(std::span<const float> positions) const;
    // Throws Error when a file has shrunk, or was written to and no longer has its checksum. Makes a stat call per
    // file.
    void check_unchanged();
    void check_intact() const;

private:
    [[nodiscard]] const MappedFile& array(const std::string& name) const { return arrays_.at(name); }
    [[nodiscard]] std::span<const std::int64_t> optional_array(const std::string& name) const {
        const auto found = arrays_.find(name);
        return found == arrays_.end() ? std::span<const std::int64_t>() : found->second.as<std::int64_t>();
    }
    [[nodiscard]] std::span<const std::uint8_t> cell_types() const { return array("cell_types").as<std::uint8_t>(); }
    // Throws the Error of views when an index of this array is out of range or contradicts another array. Any thread.
    class Keeper final : public ArrayKeeper {
    public:
        Keeper(const MappedMesh& mesh, std::string name) : mesh_(mesh), name_(std::move(name)) {}
        [[noreturn]] void refuse() const override { mesh_.refuse_changed(name_); }

    private:
        const MappedMesh& mesh_;
        std::string name_;
    };
    [[noreturn]] void refuse_changed(const std::string& suspected) const;
    [[nodiscard]] const ArrayKeeper* keeper(const std::string& name) const { return &keepers_.at(name); }
    void map(const std::string& name, ElementType type);
    void map_group(std::size_t index, std::uint64_t faces);
    void verify_checksums() const;
    [[nodiscard]] bool has_its_checksum(const std::string& name, const MappedFile& file) const;
    void verify_indices() const;
    void verify_boundary() const;

    std::filesystem::path directory_;
    AnyLost any_lost_;
    std::mutex checking_; // held by check_unchanged: was_touched and accept_touch must not run at the same time
    MeshAttributes attributes_;
    std::uint64_t vertex_count_ = 0;
    std::map<std::string, MappedFile> arrays_; // by name; groups as "groups/<index>"
    std::map<std::string, Keeper> keepers_;    // with the keys of arrays_
    std::vector<Group> groups_;
};

} // namespace ciel::store
