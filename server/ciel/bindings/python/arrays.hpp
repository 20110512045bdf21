// Converts NumPy arrays to views for the kernel, and vectors of the kernel to NumPy arrays. Not in the paper.
#pragma once

#include "ciel/array_view.hpp"

#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <utility>

namespace ciel::python {

namespace py = pybind11;

// Returns a view of `array`, which must outlive the view. `name`: for error messages. Throws ValueError unless the
// array has one or two dimensions, and TypeError for a number type that the kernel does not read.
[[nodiscard]] ArrayView view_of(const py::array& array, const char* name);
[[nodiscard]] ArrayView view_of(const std::optional<py::array>& array, const char* name); // nullopt: an empty view

// Returns a NumPy array with `columns` numbers in each row. The array owns the vector, which is moved from an rvalue or
// copied from an lvalue.
template <class Number, class Owner>
py::array_t<Number> array_of(Owner&& values, std::size_t columns) {
    using Vector = std::decay_t<Owner>;
    auto* kept = new Vector(std::forward<Owner>(values));
    const py::capsule owner(kept, [](void* vector) { delete static_cast<Vector*>(vector); });
    const auto rows = static_cast<py::ssize_t>(kept->size() * sizeof(kept->front()) / sizeof(Number) / columns);
    const auto* begin = reinterpret_cast<const Number*>(kept->data());
    if (columns == 1) return py::array_t<Number>({rows}, {sizeof(Number)}, begin, owner);
    return py::array_t<Number>({rows, static_cast<py::ssize_t>(columns)}, {columns * sizeof(Number), sizeof(Number)},
                               begin, owner);
}

// Returns a read-only NumPy array of the numbers in `values`, without a copy. `owner`: the Python object that contains
// the vector. The array keeps `owner` alive, and `owner` must not change the vector.
template <class Number, class Owned>
py::array_t<Number> view_in(const py::object& owner, const std::vector<Owned>& values, std::size_t columns) {
    static_assert(sizeof(Owned) % sizeof(Number) == 0);
    const auto rows = static_cast<py::ssize_t>(values.size() * sizeof(Owned) / sizeof(Number) / columns);
    const auto* begin = reinterpret_cast<const Number*>(values.data());
    py::array_t<Number> view = columns == 1
                                   ? py::array_t<Number>({rows}, {sizeof(Number)}, begin, owner)
                                   : py::array_t<Number>({rows, static_cast<py::ssize_t>(columns)},
                                                         {columns * sizeof(Number), sizeof(Number)}, begin, owner);
    view.attr("setflags")(py::arg("write") = false);
    return view;
}

// Returns indices as int32, because VTK takes no unsigned integers. `owner`: see view_in. `most`: upper bound of the
// indices. Throws OverflowError if `most` exceeds 2^31 - 1.
[[nodiscard]] py::array_t<std::int32_t> indices_in(const py::object& owner, const std::vector<Index>& indices,
                                                   std::size_t most, std::size_t columns = 1);

} // namespace ciel::python
