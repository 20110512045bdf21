// Decides which arrays the option --array selects, and checks that the input has the selected arrays.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace server::importer {

enum class FieldOf { points, cells };

struct ArrayName {
    FieldOf of = FieldOf::points;
    std::string name; // name in the file
};

// Returns the name of the array in the dataset. ':' becomes '_', because "U:x" means component x of the array U.
// Control characters also become '_'.
[[nodiscard]] std::string stored_name(const std::string& name);

class ArraySelection {
public:
    // `selected`: empty for all arrays. "p" selects the point array p, the cell array cell:p and the array patch:p.
    explicit ArraySelection(std::vector<std::string> selected) : selected_(std::move(selected)) {}

    // Returns whether the array is selected. `stored`: its stored_name. `cell_only`: "cell:" + stored selects it, too.
    [[nodiscard]] bool wants(const std::string& stored, bool cell_only) const;
    void saw(const ArrayName& array);
    [[nodiscard]] bool complete() const;
    // Throws Error if saw() was not called for a selected array. The text lists all arrays that were seen.
    void check() const;

private:
    [[nodiscard]] bool is_missing(const std::string& selected) const;

    std::vector<std::string> selected_;
    std::set<std::string> seen_; // names in the dataset, of all arrays passed to saw()
};

} // namespace server::importer
