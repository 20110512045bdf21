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
    // Counts values of an array, over all parts, that differ from the previous value in the input but equal it in the
    // dataset, and integers that the dataset's type cannot hold exactly. `doubles`: the dataset has the array as
    // float64. If not, it has float32, the type of the first step, even if this step has a larger type.
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
