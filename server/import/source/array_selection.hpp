// Which arrays the command line asks for, and whether the input has them.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace ciel::importer {

enum class FieldOf { points, cells };

struct ArrayName {
    FieldOf of = FieldOf::points;
    std::string name; // as the file has it
};

// The name in the dataset: ':' separates a component there ("U:x").
[[nodiscard]] std::string stored_name(const std::string& name);

class ArraySelection {
public:
    // `selected` empty: all; "p" selects p, cell:p and patch:p.
    explicit ArraySelection(std::vector<std::string> selected) : selected_(std::move(selected)) {}

    [[nodiscard]] bool wants(const std::string& stored, bool cell_only) const;
    void saw(const ArrayName& array);
    // Whether everything selected was seen.
    [[nodiscard]] bool complete() const;
    // Throws Error naming what was seen when something selected was not.
    void check() const;

private:
    [[nodiscard]] bool is_missing(const std::string& selected) const;

    std::vector<std::string> selected_;
    std::set<std::string> seen_; // stored names
};

} // namespace ciel::importer
