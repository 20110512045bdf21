// What a dataset loses because it holds 32-bit floats. It is counted and said, for nobody can see it in a picture.
#pragma once

#include "import/fields.hpp"

#include <map>
#include <string>
#include <vector>

namespace ciel::importer {

// Sentences. Of the joined mesh before welding: cells with corners that are apart in the input and one here, and cells
// whose volume changes by 1 %.
[[nodiscard]] std::vector<std::string> mesh_loss(const JoinedMesh& mesh);

// Of arrays, over all steps.
class ValueLoss {
public:
    // Looks at an array of all parts: neighbours in the input that differ there and are equal here, and integers that
    // no float is equal to.
    void look_at(const std::vector<JoinedMesh::Part>& parts, const FieldName& field);
    // A sentence for each array that lost something.
    [[nodiscard]] std::vector<std::string> notes() const;

private:
    struct Count {
        std::uint64_t equal = 0, integers = 0, values = 0;
    };
    std::map<std::string, Count> counts_; // by name, "cell:" before those of cells
};

} // namespace ciel::importer
