// Counts values that change because a dataset stores 32-bit floats. A picture does not show this loss.
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
    // Counts, in an array of all parts, values that differ from the previous value in the input but not as floats, and
    // integers that no float is equal to.
    void look_at(const std::vector<JoinedMesh::Member>& parts, const FieldName& field);
    // Returns sentences on the arrays with changed values.
    [[nodiscard]] std::vector<std::string> notes() const;

private:
    struct Count {
        std::uint64_t equal = 0, integers = 0, values = 0;
    };
    std::map<std::string, Count> counts_; // by array name, with the prefix "cell:" for cell arrays
};

} // namespace ciel::importer
