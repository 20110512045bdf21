// Counts values that change because of the type in which a dataset stores them. A picture does not show this loss.
#pragma once

#include "import/values/fields.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ciel::importer {

// Adds up the counts of each array over all steps.
class ValueLoss {
public:
    // Counts, in an array of all parts, values that differ from the previous value in the input but not in the dataset,
    // and integers that no number of the dataset is equal to. `doubles`: the dataset has the array as float64, else as
    // float32, which happens if a later step has a larger type than the first.
    void look_at(const std::vector<JoinedMesh::Member>& parts, const FieldName& field, bool doubles);
    // Returns sentences on the arrays with changed values.
    [[nodiscard]] std::vector<std::string> notes() const;

private:
    struct Count {
        std::uint64_t equal = 0, integers = 0, values = 0;
        bool doubles = false;
    };
    std::map<std::string, Count> counts_; // by array name, with the prefix "cell:" for cell arrays
};

} // namespace ciel::importer
