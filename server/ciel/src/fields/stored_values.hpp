// The caller's values in the order of the stored mesh. Not in the paper.
#pragma once

#include "ciel/mesh.hpp"
#include "ciel/values_view.hpp"

#include <variant>
#include <vector>

namespace ciel::detail {

enum class PerItem { point, cell };

// Owns the values: floats if the caller's numbers are 32-bit floats or 8-bit integers, else doubles.
class StoredValues {
public:
    // values: one number per point or cell of the caller's mesh. Throws Error if the number of rows or columns is
    // wrong.
    StoredValues(const Mesh& mesh, const ArrayView& values, PerItem item);

    [[nodiscard]] ValuesView view() const {
        return std::visit([](const auto& all) { return ValuesView(all); }, values_);
    }
    // Calls f with the vector of floats or of doubles. f may move from the vector.
    template <class F>
    decltype(auto) with(F&& f) {
        return std::visit(std::forward<F>(f), values_);
    }

private:
    std::variant<std::vector<float>, std::vector<double>> values_;
};

} // namespace ciel::detail
