// The table of steps: two binary files with all steps of a dataset but the last few, which are in the commit marker
// (store/README.md, "The table of steps"). Opening a dataset reads 40 bytes for a step of the table. The arrays of a
// step are read at its first use.
#pragma once

#include "store/format/marker.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ciel::store {

class InputFile; // files/files.hpp

// Immutable and thread-safe. Keeps the file of arrays open.
class StepTable {
public:
    // Reads the rows of the steps that `facts` counts; the files may be longer. Throws FileError when one is missing,
    // damaged or of another dataset.
    StepTable(const std::filesystem::path& dataset, const TableFacts& facts, const std::string& dataset_id);
    ~StepTable();
    StepTable(const StepTable&) = delete;
    StepTable& operator=(const StepTable&) = delete;

    [[nodiscard]] std::size_t size() const { return rows_.size(); }
    [[nodiscard]] double time(std::size_t step) const { return rows_[step].time; } // ascending
    // Reads a step. Throws FileError when its part of the file is damaged.
    [[nodiscard]] MarkedStep step(std::size_t step) const;

private:
    friend TableFacts append_to_table(const std::filesystem::path&, const TableFacts&, const std::string&,
                                      std::span<const MarkedStep>);
    struct Row {
        double time;
        std::uint32_t mesh, coordinates;
        std::uint64_t begin; // in the file of arrays, in bytes
        std::uint32_t bytes, arrays;
        std::uint64_t checksum; // XXH3-64 of these bytes
    };
    static_assert(sizeof(Row) == 40);

    std::vector<TableArray> arrays_of_;
    std::vector<Row> rows_;
    std::unique_ptr<InputFile> arrays_;
};

// Appends steps to the table that `facts` describes, and returns the facts of the longer one. Bytes of the longer table
// count only when the commit marker has been replaced, so a reader sees the old or the new table. Truncates bytes that
// no marker counts. Flushes the files to the disk. Throws FileError when they cannot be written or are damaged.
[[nodiscard]] TableFacts append_to_table(const std::filesystem::path& dataset, const TableFacts& facts,
                                         const std::string& dataset_id, std::span<const MarkedStep> steps);

} // namespace ciel::store
