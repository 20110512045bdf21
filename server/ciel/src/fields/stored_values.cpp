#include "fields/stored_values.hpp"

#include <string>

namespace ciel::detail {

namespace {

template <class T>
std::vector<T> in_stored_order(const ArrayView& values, std::span<const Index> original, std::size_t count) {
    std::vector<T> stored(count);
    for (std::size_t i = 0; i < count; ++i) stored[i] = static_cast<T>(values.real(original.empty() ? i : original[i]));
    return stored;
}

} // namespace

StoredValues::StoredValues(const Mesh& mesh, const ArrayView& values, PerItem item) {
    const bool is_point = item == PerItem::point;
    const std::size_t wanted = is_point ? mesh.point_count() : mesh.cell_count();
    if (values.rows() != wanted || values.columns() != 1)
        fail("values must be one number per " + std::string(is_point ? "point" : "cell") + " of the mesh (" +
             std::to_string(wanted) + "), not " + std::to_string(values.rows()) + " rows of " +
             std::to_string(values.columns()));
    const std::span<const Index> original = is_point ? mesh.original_vertex() : mesh.original_cell();
    const std::size_t count = is_point ? mesh.stored().vertex_count() : mesh.stored().cell_count();
    if (values.type() == NumberType::float32 || values.type() == NumberType::uint8)
        values_ = in_stored_order<float>(values, original, count);
    else
        values_ = in_stored_order<double>(values, original, count);
}

} // namespace ciel::detail
