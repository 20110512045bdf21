// MappedMesh: the mapped arrays of one mesh, and its blocks. A dataset and its refreshed versions share the object.
#pragma once

#include "store/cache/checked_file.hpp"
#include "store/cache/stored_blocks.hpp"
#include "store/format/attributes.hpp"
#include "store/format/number_groups.hpp"
#include "store/format/zarr_array.hpp"

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

namespace server::store {

class MappedMesh : public std::enable_shared_from_this<MappedMesh> {
public:
    MappedMesh(const MappedMesh&) = delete;
    MappedMesh& operator=(const MappedMesh&) = delete;
    // Maps the arrays except positions and values, and reads the index of the blocks, but not the content of an array.
    // Throws Error that names the file when a file is missing, has a wrong size, or belongs to another dataset.
    // `access`: whether the records are mapped or copied.
    MappedMesh(std::filesystem::path directory, const std::string& dataset_id, LossCount losses, FileAccess access);

    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }
    [[nodiscard]] const MeshAttributes& attributes() const { return attributes_; }
    [[nodiscard]] std::uint64_t vertex_count() const { return vertex_count_; }
    [[nodiscard]] std::uint64_t cell_count() const { return cell_types().size(); }
    // When an array is first requested, the functions below check its checksum and its indices. They throw Error that
    // names a damaged file. Files may change later. Therefore views check each index again when the index is read.
    [[nodiscard]] const std::vector<Group>& groups() const;
    [[nodiscard]] std::span<const ciel::Index> original_vertex() const { return ids<ciel::Index>("original_vertex"); }
    [[nodiscard]] std::span<const ciel::Index> original_cell() const { return ids<ciel::Index>("original_cell"); }
    // An id of -1 means that the solver gave no id. Empty if the imported file has no solver ids.
    [[nodiscard]] std::span<const std::int64_t> solver_vertex() const { return ids<std::int64_t>("solver_vertex"); }
    [[nodiscard]] std::span<const std::int64_t> solver_cell() const { return ids<std::int64_t>("solver_cell"); }
    // Return the id of one vertex or cell; nullopt if the imported file has no solver ids. Check only the stretch
    // (format/checksum.hpp) that contains the id.
    [[nodiscard]] ciel::Index original_vertex(ciel::Index vertex) const {
        return *id<ciel::Index>("original_vertex", vertex);
    }
    [[nodiscard]] ciel::Index original_cell(ciel::Index cell) const { return *id<ciel::Index>("original_cell", cell); }
    [[nodiscard]] std::optional<std::int64_t> solver_vertex(ciel::Index vertex) const {
        return id<std::int64_t>("solver_vertex", vertex);
    }
    [[nodiscard]] std::optional<std::int64_t> solver_cell(ciel::Index cell) const {
        return id<std::int64_t>("solver_cell", cell);
    }
    // `positions`: offsets from the mesh's origin. Returns no faces and reads no array.
    [[nodiscard]] ciel::FaceMeshView view_points(ciel::ValuesView positions) const;
    [[nodiscard]] ciel::FaceMeshView numbered_faces(ciel::FaceMeshView points) const;
    [[nodiscard]] ciel::FaceMeshView boundary(ciel::FaceMeshView points) const;
    // Returns `points` with all faces of the mesh. In format 2, the inner faces are made from the blocks. In format 1,
    // all faces are read from arrays.
    [[nodiscard]] ciel::FaceMeshView all_faces(ciel::FaceMeshView points) const;
    // Returns false for a mesh of an earlier version of CIEL, which stored no blocks.
    [[nodiscard]] bool has_blocks() const { return blocks_ != nullptr; }
    [[nodiscard]] ciel::Topology stored_topology() const { return blocks_->topology(); }
    [[nodiscard]] ciel::Index block_count() const { return blocks_->block_count(); }
    void verify() const; // reads and checks all arrays and records; throws Error at the first damaged file
    // Throws Error when a file has shrunk, or has changed and no longer matches its checksum. Calls stat for each file.
    void check_unchanged();
    void check_intact() const;

private:
    [[nodiscard]] const MappedFile& array(const std::string& name) const { return arrays_.at(name); }
    template <typename T>
    [[nodiscard]] std::span<const T> ids(const std::string& name) const {
        const auto found = arrays_.find(name);
        if (found == arrays_.end()) return {};
        load_stretches(found->second, stretches_of(name), 0, found->second.bytes().size());
        return found->second.as<T>();
    }
    template <typename T>
    [[nodiscard]] std::optional<T> id(const std::string& name, ciel::Index of) const {
        const auto found = arrays_.find(name);
        if (found == arrays_.end()) return std::nullopt;
        load_stretches(found->second, stretches_of(name), of * sizeof(T), (std::size_t{of} + 1) * sizeof(T));
        return found->second.as<T>()[of];
    }
    [[nodiscard]] CheckedStretches& stretches_of(const std::string& ids) const;
    [[nodiscard]] std::span<const std::uint8_t> cell_types() const { return array("cell_types").as<std::uint8_t>(); }
    // A view calls refuse() on any thread when an index is out of range or contradicts another array.
    class Keeper final : public ciel::ArrayKeeper {
    public:
        Keeper(const MappedMesh& mesh, std::string name) : mesh_(mesh), name_(std::move(name)) {}
        [[noreturn]] void refuse() const override { mesh_.refuse_changed(name_); }

    private:
        const MappedMesh& mesh_;
        std::string name_;
    };
    [[noreturn]] void refuse_changed(const std::string& suspected) const;
    [[nodiscard]] const ciel::ArrayKeeper* keeper(const std::string& name) const { return &keepers_.at(name); }
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
    // In format 2, these arrays are in a folder and have the numbered faces. In format 1, they have all faces, without
    // a folder.
    [[nodiscard]] std::string face_array(const std::string& name) const { return face_folder_ + name; }
    [[nodiscard]] bool has_numbers() const { return !face_folder_.empty(); }
    [[nodiscard]] std::uint64_t stored_faces() const { return array(face_array("owner")).as<ciel::Index>().size(); }
    [[nodiscard]] ciel::FaceMeshView with_stored_faces(ciel::FaceMeshView points) const;
    void number_faces() const;
    [[nodiscard]] ciel::FaceMeshView first_faces(ciel::FaceMeshView faces) const;

    std::filesystem::path directory_;
    std::string dataset_id_;
    LossCount losses_;
    std::mutex checking_; // held by check_unchanged, because two threads must not call was_touched at the same time
    MeshAttributes attributes_;
    std::uint64_t vertex_count_ = 0;
    std::map<std::string, MappedFile> arrays_; // by name; the name of a group is "groups/<index>"
    std::map<std::string, Keeper> keepers_;    // same keys as arrays_
    mutable std::vector<Group> groups_;
    std::string face_folder_;                    // "faces/", or empty in format 1
    std::shared_ptr<const StoredBlocks> blocks_; // null if the mesh was stored without blocks
    mutable NumberedGroups numbered_;            // only in format 1; made when faces or groups are first used
    mutable std::mutex making_faces_;
    mutable std::weak_ptr<const ciel::FaceLists> all_faces_; // null if no caller uses all faces

    // Runs a check at the first call of once(). If the check throws, the next call runs it again. Thread-safe.
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
    // By name of an array of layout::id_arrays; null until the array is first used.
    mutable std::map<std::string, std::unique_ptr<CheckedStretches>> stretches_;
    mutable std::map<std::string, Verified> verified_; // by name of an array, or of a check of several arrays
};

} // namespace server::store
