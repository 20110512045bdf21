// Counts values that change because the dataset stores them in another type. A picture does not show this loss.
#pragma once

#include "import/values/fields.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace server::importer {

// Adds up the counts of each array over all steps.
class ValueLoss {
public:
    // Counts values that differ from the previous value in the input but not in the dataset, and integers that the type
    // in the dataset cannot hold exactly. `doubles`: whether the dataset stores the array as float64. If false, the
    // dataset stores float32, the type of the array's first step, even if `field` is float64.
    void look_at(const std::vector<JoinedMesh::Member>& members, const FieldName& field, bool doubles);
    [[nodiscard]] std::vector<std::string> notes() const;

private:
    struct Count {
        std::uint64_t equal = 0, integers = 0, values = 0;
        bool doubles = false;
    };
    std::map<std::string, Count> counts_; // by array name, with the prefix "cell:" for cell arrays
};

} // namespace server::importer
