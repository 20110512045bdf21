// MappedMesh: the arrays of one mesh, mapped, and its blocks. All refreshes of a dataset share it.
#pragma once

#include "store/cache/paged_file.hpp"
#include "store/cache/stored_blocks.hpp"
#include "store/format/attributes.hpp"
#include "store/format/number_groups.hpp"
#include "store/format/zarr_array.hpp"

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

namespace ciel::store {

class MappedMesh {
public:
    MappedMesh(const MappedMesh&) = delete;
    MappedMesh& operator=(const MappedMesh&) = delete;
    // Maps the arrays of a mesh except positions and values, and reads the index of its blocks. Reads no array. Throws
    // Error that names the file when one is missing, has a wrong size, or is not of this dataset. `any_lost`: whether
    // any mapped file has changed since. `access`: whether the records are mapped or copied.
    MappedMesh(std::filesystem::path directory, const std::string& dataset_id, AnyLost any_lost, FileAccess access);

    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }
    [[nodiscard]] const MeshAttributes& attributes() const { return attributes_; }
    [[nodiscard]] std::uint64_t vertex_count() const { return vertex_count_; }
    [[nodiscard]] std::uint64_t cell_count() const { return cell_types().size(); }
    // These functions compare an array with its checksum, and its indices with the arrays that they point into, when it
    // is first asked for. They throw Error that names the file. Files may change afterwards, so views check each index
    // that they read.
    [[nodiscard]] const std::vector<Group>& groups() const;
    [[nodiscard]] std::span<const Index> original_vertex() const { return ids<Index>("original_vertex"); }
    [[nodiscard]] std::span<const Index> original_cell() const { return ids<Index>("original_cell"); }
    // Ids that the solver gave to vertices and cells, -1 where it gave none; empty if the source has no such ids.
    [[nodiscard]] std::span<const std::int64_t> solver_vertex() const { return ids<std::int64_t>("solver_vertex"); }
    [[nodiscard]] std::span<const std::int64_t> solver_cell() const { return ids<std::int64_t>("solver_cell"); }
    // Return the ids of one vertex or cell; nullopt if the source has no such ids. Only the page that holds the id is
    // compared with its checksum.
    [[nodiscard]] Index original_vertex(Index vertex) const { return *id<Index>("original_vertex", vertex); }
    [[nodiscard]] Index original_cell(Index cell) const { return *id<Index>("original_cell", cell); }
    [[nodiscard]] std::optional<std::int64_t> solver_vertex(Index vertex) const {
        return id<std::int64_t>("solver_vertex", vertex);
    }
    [[nodiscard]] std::optional<std::int64_t> solver_cell(Index cell) const {
        return id<std::int64_t>("solver_cell", cell);
    }
    // Returns the mesh with these positions, which are offsets from its origin, and without faces. Reads no array.
    [[nodiscard]] FaceMeshView view_points(ValuesView positions) const;
    // Returns these points with the numbered faces (ciel/numbered_faces.hpp).
    [[nodiscard]] FaceMeshView numbered_faces(FaceMeshView points) const;
    [[nodiscard]] FaceMeshView boundary(FaceMeshView points) const; // the first of these: those on the boundary
    // Returns these points with all faces. Those inside come from the blocks, except in format 1.
    [[nodiscard]] FaceMeshView all_faces(FaceMeshView points) const;
    // Returns false for a mesh of an earlier version of CIEL, which stored no blocks.
    [[nodiscard]] bool has_blocks() const { return blocks_ != nullptr; }
    [[nodiscard]] Topology stored_topology() const { return blocks_->topology(); }
    [[nodiscard]] Index block_count() const { return blocks_->block_count(); }
    void verify() const; // reads all arrays and records; throws Error at the first that is damaged
    // Throws Error when a file has shrunk, or when it was written to or replaced and its mapping no longer has the
    // checksum. Makes a stat call per file.
    void check_unchanged();
    void check_intact() const;

private:
    [[nodiscard]] const MappedFile& array(const std::string& name) const { return arrays_.at(name); }
    // Returns an array of ids that are no indices; empty if the mesh does not have the array.
    template <typename T>
    [[nodiscard]] std::span<const T> ids(const std::string& name) const {
        const auto found = arrays_.find(name);
        if (found == arrays_.end()) return {};
        load_pages(found->second, pages_of(name), 0, found->second.bytes().size());
        return found->second.as<T>();
    }
    template <typename T>
    [[nodiscard]] std::optional<T> id(const std::string& name, Index of) const {
        const auto found = arrays_.find(name);
        if (found == arrays_.end()) return std::nullopt;
        load_pages(found->second, pages_of(name), of * sizeof(T), (std::size_t{of} + 1) * sizeof(T));
        return found->second.as<T>()[of];
    }
    [[nodiscard]] PageStates& pages_of(const std::string& ids) const;
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
    void map_group(std::size_t index);
    void check_sizes() const;
    [[nodiscard]] const std::string& checksum_of(const std::string& name) const; // throws Error if it is missing
    void verify_checksums(const std::vector<std::string>& names) const;
    [[nodiscard]] bool has_its_checksum(const std::string& name, const MappedFile& file) const;
    void verify_faces() const;
    void verify_types() const;
    void check_order() const;
    void verify_groups() const;
    void check_boundary_count(std::uint64_t count) const;
    // Returns the name of an array of faces with its folder. Format 1 has no folder, and its arrays have all faces.
    [[nodiscard]] std::string face_array(const std::string& name) const { return face_folder_ + name; }
    [[nodiscard]] bool has_numbers() const { return !face_folder_.empty(); }
    [[nodiscard]] std::uint64_t stored_faces() const { return array(face_array("owner")).as<Index>().size(); }
    [[nodiscard]] FaceMeshView with_stored_faces(FaceMeshView points) const;
    void number_faces() const;
    [[nodiscard]] FaceMeshView first_faces(FaceMeshView faces) const;

    std::filesystem::path directory_;
    std::string dataset_id_;
    AnyLost any_lost_;
    std::mutex checking_; // held by check_unchanged: was_touched must not run twice at the same time
    MeshAttributes attributes_;
    std::uint64_t vertex_count_ = 0;
    std::map<std::string, MappedFile> arrays_; // by name; groups as "groups/<index>"
    std::map<std::string, Keeper> keepers_;    // with the keys of arrays_
    mutable std::vector<Group> groups_;
    std::string face_folder_;                    // "faces/", or empty in format 1
    std::shared_ptr<const StoredBlocks> blocks_; // null if the mesh was stored without blocks
    mutable NumberedGroups numbered_;            // in format 1: made at the first use of the faces or the groups
    mutable std::mutex making_faces_;
    mutable std::weak_ptr<const FaceLists> all_faces_; // null unless somebody uses them

    // Runs a check until it has passed once. Thread-safe.
    class Verified {
    public:
        template <typename Check>
        void once(Check&& check) {
            if (done_.load(std::memory_order_acquire)) return;
            const std::lock_guard lock(checking_);
            if (done_.load(std::memory_order_relaxed)) return;
            check();
            done_.store(true, std::memory_order_release);
        }

    private:
        std::mutex checking_;
        std::atomic<bool> done_ = false;
    };
    // By name of an array of ids that are no indices; null before their first use.
    mutable std::map<std::string, std::unique_ptr<PageStates>> pages_;
    mutable std::map<std::string, Verified> verified_; // by name of an array of ids, or of a check
};

} // namespace ciel::store
