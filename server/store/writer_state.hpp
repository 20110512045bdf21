// The data of a Writer, and how it puts files into the dataset.
#pragma once

#include "store/cache/stored_blocks.hpp"
#include "store/commit.hpp"
#include "store/files/files.hpp"
#include "store/format/layout.hpp"
#include "store/new_dataset_directory.hpp"
#include "store/write_mesh.hpp"
#include "store/writer.hpp"

namespace server::store {

struct WrittenMesh {
    MeshAttributes attributes;
    std::map<std::string, ArrayInfo> arrays;
    std::uint64_t steps = 0;

    [[nodiscard]] std::uint64_t items(const ArrayInfo& array) const {
        return items_of(attributes.info, array.association);
    }
};

struct StepUnderWay {
    MarkedStep step;
    std::vector<ArrayInfo> arrays;
    std::vector<std::filesystem::path> chunks;
};

struct Writer::State {
    std::filesystem::path directory; // temporary directory of a new dataset, or the dataset when appending
    std::unique_ptr<NewDatasetDirectory> new_directory; // null when appending
    Descriptor lock;                                    // when appending: lock on the dataset's directory
    std::shared_ptr<Dataset> before;
    DatasetInfo info;
    Marker marker;
    std::optional<double> last_time; // time of the last step; nullopt if there is none
    std::vector<WrittenMesh> meshes;
    struct UsedMesh {
        std::size_t mesh;
        std::shared_ptr<const StoredBlocks> blocks; // null in format 1
        ciel::Topology topology;
    };
    std::optional<UsedMesh> used; // the mesh whose topology was used last; only one, because it keeps files open
    std::unique_ptr<StepUnderWay> under_way;
    bool info_changed = false, finished = false;

    State() = default;
    ~State() { take_back(); }
    State(const State&) = delete;

    [[nodiscard]] bool appending() const { return new_directory == nullptr; }

    [[nodiscard]] WrittenMesh& mesh(std::size_t index);

    // When appending, replaces the file, because a reader may have mapped it. In a new dataset, writes it directly.
    void put(const std::filesystem::path& file, std::span<const std::byte> bytes) const {
        appending() ? replace_file(file, bytes) : write_file(file, bytes);
    }

    // Skips a file that has this content already, because replacing it would flush it to the disk.
    void put_text(const std::filesystem::path& file, const std::string& text) const;

    void put_array(const ArrayInfo& array, const WrittenMesh& on, const std::filesystem::path& path,
                   std::uint64_t steps) const;

    void put_mesh(std::size_t index) const;

    void put_root() const;

    [[nodiscard]] Commit commit() const { return {directory, info.id, appending()}; }

    void check_array(const ArrayValues& array, const WrittenMesh& on) const;

    [[nodiscard]] const ArrayInfo* find(const std::string& array) const;

    [[nodiscard]] ArrayInfo with_type(const ArrayInfo& array, ciel::ValuesView values) const;

    // REQUIRES: the values have the array's type.
    void put_values(const ArrayInfo& array, ciel::ValuesView values);

    void put_ranges(const ArrayInfo& array, ciel::ValuesView values, const std::filesystem::path& path,
                    std::uint64_t row);

    [[nodiscard]] bool has_blocks(std::size_t mesh) const {
        std::error_code error;
        return std::filesystem::exists(layout::block_index(layout::mesh(directory, mesh)).parent_path(), error);
    }
    [[nodiscard]] const ciel::Topology& topology_of(std::size_t mesh);
    // Throws Error if records that were used have changed or could not be read again.
    void check_used() const {
        if (used && used->blocks) used->blocks->check_intact();
    }

    std::size_t add_mesh(const NewMesh& mesh, const OriginalIds& original, std::span<const NamedGroup> groups,
                         const SolverIds& solver);

    void put_documents() const;

    void place_extremes(MarkedStep& step);

    void learn_arrays(const StepUnderWay& of);

    // Deletes the chunks of the step that is being written, which no reader has seen.
    void take_back() noexcept;
};

} // namespace server::store
