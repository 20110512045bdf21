// What arrays lose because a dataset holds 32-bit floats. It is counted and said: nobody can see it in a picture.
#pragma once

#include "import/values/fields.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ciel::importer {

// Of arrays, over all steps.
class ValueLoss {
public:
    // Looks at an array of all parts: neighbours in the input that differ there and are equal here, and integers that
    // no float is equal to.
    void look_at(const std::vector<JoinedMesh::Member>& parts, const FieldName& field);
    // A sentence for each array that lost something.
    [[nodiscard]] std::vector<std::string> notes() const;

private:
    struct Count {
        std::uint64_t equal = 0, integers = 0, values = 0;
    };
    std::map<std::string, Count> counts_; // by name, "cell:" before those of cells
};

} // namespace ciel::importer
