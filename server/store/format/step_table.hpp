// The table of steps: two binary files with all steps of a dataset except the last steps, which are in the commit
// marker (store/README.md, "The table of steps"). Opening a dataset reads 40 bytes for each step of the table.
#pragma once

#include "store/format/marker.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace server::store {

class InputFile; // files/files.hpp

// Immutable and thread-safe. Keeps the file `steps/arrays` open.
class StepTable {
public:
    // Reads the first `facts.steps` rows. Throws FileError when a file is missing, damaged or of another dataset.
    StepTable(const std::filesystem::path& dataset, const TableFacts& facts, const std::string& dataset_id);
    ~StepTable();
    StepTable(const StepTable&) = delete;
    StepTable& operator=(const StepTable&) = delete;

    [[nodiscard]] std::size_t size() const { return rows_.size(); }
    [[nodiscard]] double time(std::size_t step) const { return rows_[step].time; } // ascending
    // Throws FileError when the bytes of the step are damaged.
    [[nodiscard]] MarkedStep step(std::size_t step) const;

private:
    friend TableFacts append_to_table(const std::filesystem::path&, const TableFacts&, const std::string&,
                                      std::span<const MarkedStep>);
    struct Row {
        double time;
        std::uint32_t mesh, coordinates;
        std::uint64_t begin;         // offset of the step's arrays in the file `steps/arrays`, in bytes
        std::uint32_t bytes, arrays; // length of the step's arrays in bytes; number of arrays
        std::uint64_t checksum;      // XXH3-64 of the step's arrays
    };
    static_assert(sizeof(Row) == 40);

    std::vector<TableArray> arrays_of_;
    std::vector<Row> rows_;
    std::unique_ptr<InputFile> arrays_;
};

// Appends steps to the table that `facts` describes, and flushes the files. First removes all bytes after the old
// table, which no marker describes. The caller writes the returned description to the commit marker. Until then,
// readers see the old table. Throws FileError when a file is damaged or cannot be written.
[[nodiscard]] TableFacts append_to_table(const std::filesystem::path& dataset, const TableFacts& facts,
                                         const std::string& dataset_id, std::span<const MarkedStep> steps);

} // namespace server::store
