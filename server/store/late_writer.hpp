// LateWriter: writes late arrays, whose values have been read from the source after the import.
#pragma once

#include "store/late_files.hpp"
#include "store/writer.hpp"

#include <functional>
#include <map>
#include <optional>

namespace server::store {

// Not thread-safe.
class LateWriter {
public:
    // Waits while another process writes late arrays of the dataset. Meanwhile, calls wait() several times a second;
    // wait() may throw to give up. `folder`: see LateFiles. Throws Error when the files cannot be written.
    enum class Where { in_the_dataset_if_writable, elsewhere };
    LateWriter(std::shared_ptr<const Dataset> dataset, const std::filesystem::path& folder,
               const std::function<void()>& wait, Where where = Where::in_the_dataset_if_writable);

    // Returns whether an array of the step is late and has not been written.
    [[nodiscard]] bool lacks(std::size_t step) const;
    [[nodiscard]] bool lacks(std::size_t step, const std::string& array) const;
    // Writes the array. Does nothing if the array is not late, or has been written already. The values are converted to
    // the type of the array. Throws Error when their number is wrong, or when a file cannot be written; the array is
    // then still late.
    void put(std::size_t step, const ArrayValues& array);
    // Marks the late arrays that were not put as missing in the source at this step. Tells readers that arrays were
    // written.
    void end_step(std::size_t step);
    void tell_readers() const; // that arrays were written
    // Directory in which the files are written: that of the dataset, or one in `folder`.
    [[nodiscard]] const std::filesystem::path& directory() const { return directory_; }

private:
    void write(const Step& step, const ArrayInfo& array, std::uint64_t chunk, ciel::ValuesView values);
    static void write_facts(const std::filesystem::path& array, std::uint64_t chunk,
                            const std::optional<MarkedArray>& facts);
    [[nodiscard]] std::filesystem::path array_directory(std::size_t mesh, const std::string& array) const;
    [[nodiscard]] const ciel::Topology& topology(std::size_t mesh);

    std::shared_ptr<const Dataset> dataset_;
    LateFiles files_;
    std::filesystem::path directory_;
    Descriptor lock_;
    std::map<std::size_t, ciel::Topology> topologies_; // by mesh
};

} // namespace server::store
