// The arrays that --array selects, and whether the input has them.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace ciel::importer {

enum class FieldOf { points, cells };

struct ArrayName {
    FieldOf of = FieldOf::points;
    std::string name; // name in the file
};

// Returns the name in the dataset: ':' and control characters become '_', because ':' separates a component ("U:x").
[[nodiscard]] std::string stored_name(const std::string& name);

class ArraySelection {
public:
    // Empty `selected`: all arrays. "p" selects p, cell:p and patch:p.
    explicit ArraySelection(std::vector<std::string> selected) : selected_(std::move(selected)) {}

    [[nodiscard]] bool wants(const std::string& stored, bool cell_only) const;
    void saw(const ArrayName& array);
    // Returns whether saw() was called for every selected array.
    [[nodiscard]] bool complete() const;
    // Throws Error with the names of all seen arrays if a selected array was not seen.
    void check() const;

private:
    [[nodiscard]] bool is_missing(const std::string& selected) const;

    std::vector<std::string> selected_;
    std::set<std::string> seen_; // names in the dataset
};

} // namespace ciel::importer
