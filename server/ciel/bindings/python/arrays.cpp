#include "arrays.hpp"

#include <limits>
#include <stdexcept>

namespace ciel::python {

namespace {

NumberType type_of(const py::array& array, const char* name) {
    const py::dtype type = array.dtype();
    const char kind = type.kind();
    const auto size = type.itemsize();
    const bool is_native = type.attr("isnative").cast<bool>();
    if (is_native && kind == 'f' && size == 4) return NumberType::float32;
    if (is_native && kind == 'f' && size == 8) return NumberType::float64;
    if (is_native && kind == 'i' && size == 4) return NumberType::int32;
    if (is_native && kind == 'i' && size == 8) return NumberType::int64;
    if (is_native && kind == 'u' && size == 4) return NumberType::uint32;
    if (is_native && kind == 'u' && size == 8) return NumberType::uint64;
    if (is_native && kind == 'u' && size == 1) return NumberType::uint8;
    throw py::type_error(
        std::string(name) + " has the type " + py::str(static_cast<py::handle>(type)).cast<std::string>() +
        "; use float32, float64, uint8, or integers of 32 or 64 bits, in the byte order of this machine");
}

} // namespace

ArrayView view_of(const py::array& array, const char* name) {
    if (array.ndim() != 1 && array.ndim() != 2)
        throw py::value_error(std::string(name) + " must have one or two dimensions, not " +
                              std::to_string(array.ndim()));
    const bool is_table = array.ndim() == 2;
    return {array.data(),
            type_of(array, name),
            static_cast<std::size_t>(array.shape(0)),
            is_table ? static_cast<std::size_t>(array.shape(1)) : 1,
            array.strides(0),
            is_table ? array.strides(1) : 0};
}

ArrayView view_of(const std::optional<py::array>& array, const char* name) {
    return array ? view_of(*array, name) : ArrayView();
}

py::array_t<std::int32_t> indices_in(const py::object& owner, const std::vector<Index>& indices, std::size_t most,
                                     std::size_t columns) {
    if (most > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
        throw std::overflow_error(
            "the surface has more than 2^31 - 1 points or corners; cut some blocks at a time (blocks=)");
    return view_in<std::int32_t>(owner, indices, columns);
}

} // namespace ciel::python
