// ArrayView: a non-owning view of a caller's array of numbers, with strides. Not in the paper.
#pragma once

#include "ciel/types.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ciel {

enum class NumberType : std::uint8_t { uint8, int32, uint32, int64, uint64, float32, float64 };

template <class T>
inline constexpr bool is_array_number =
    std::same_as<T, std::uint8_t> || std::same_as<T, std::int32_t> || std::same_as<T, std::uint32_t> ||
    std::same_as<T, std::int64_t> || std::same_as<T, std::uint64_t> || std::same_as<T, float> ||
    std::same_as<T, double>;

template <class T>
requires is_array_number<T>
[[nodiscard]] constexpr NumberType number_type() {
    if constexpr (std::same_as<T, std::uint8_t>) return NumberType::uint8;
    if constexpr (std::same_as<T, std::int32_t>) return NumberType::int32;
    if constexpr (std::same_as<T, std::uint32_t>) return NumberType::uint32;
    if constexpr (std::same_as<T, std::int64_t>) return NumberType::int64;
    if constexpr (std::same_as<T, std::uint64_t>) return NumberType::uint64;
    if constexpr (std::same_as<T, float>) return NumberType::float32;
    return NumberType::float64;
}

// View of a table of numbers with `rows` rows and `columns` columns. Does not own the array and never writes to it. The
// array must outlive every call that receives the view.
class ArrayView {
public:
    ArrayView() = default;
    // Views `values` as rows of `columns` numbers without gaps. Leaves out an incomplete last row.
    // REQUIRES: columns > 0.
    template <class T>
    requires is_array_number<T> ArrayView(std::span<const T> values, std::size_t columns = 1)
        : ArrayView(values.data(), number_type<T>(), values.size() / columns, columns,
                    static_cast<std::ptrdiff_t>(columns * sizeof(T)), sizeof(T)) {}
    template <class T>
    requires is_array_number<T> ArrayView(const std::vector<T>& values, std::size_t columns = 1)
        : ArrayView(std::span<const T>(values), columns) {}
    // `begin`: the number at row 0 and column 0. The strides are in bytes: `row_stride` is the distance from a row to
    // the next, `column_stride` the distance from a column to the next. Both may be negative, as in NumPy.
    ArrayView(const void* begin, NumberType type, std::size_t rows, std::size_t columns, std::ptrdiff_t row_stride,
              std::ptrdiff_t column_stride)
        : begin_(static_cast<const std::byte*>(begin)), type_(type), rows_(rows), columns_(columns),
          row_stride_(row_stride), column_stride_(column_stride) {}

    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] std::size_t columns() const { return columns_; }
    [[nodiscard]] bool empty() const { return rows_ == 0; }
    [[nodiscard]] NumberType type() const { return type_; }
    // Returns all numbers, row by row, if the array has the type T and no gaps. Otherwise returns an empty span. Lets
    // callers read the array without a copy.
    template <class T>
    requires is_array_number<T>
    [[nodiscard]] std::span<const T> as() const {
        const bool is_dense = column_stride_ == static_cast<std::ptrdiff_t>(sizeof(T)) &&
                              row_stride_ == static_cast<std::ptrdiff_t>(columns_ * sizeof(T));
        if (type_ != number_type<T>() || !is_dense) return {};
        return {reinterpret_cast<const T*>(begin_), rows_ * columns_};
    }

    [[nodiscard]] ArrayView column(std::size_t column) const { // REQUIRES: column < columns()
        return {begin_ + static_cast<std::ptrdiff_t>(column) * column_stride_,
                type_,
                rows_,
                1,
                row_stride_,
                column_stride_};
    }
    // Returns one number, converted to double from the type of the array.
    // REQUIRES: row < rows(), column < columns().
    [[nodiscard]] double real(std::size_t row, std::size_t column = 0) const;
    // Returns one number as a signed integer. A uint64 above the int64 range becomes a negative number. Throws Error
    // when the array has floating-point numbers. REQUIRES: row < rows(), column < columns().
    [[nodiscard]] std::int64_t integer(std::size_t row, std::size_t column = 0) const;
    [[nodiscard]] bool has_integers() const { return type_ != NumberType::float32 && type_ != NumberType::float64; }

private:
    template <class T>
    [[nodiscard]] T at(std::size_t row, std::size_t column) const;

    const std::byte* begin_ = nullptr;
    NumberType type_ = NumberType::float32;
    std::size_t rows_ = 0, columns_ = 1;
    std::ptrdiff_t row_stride_ = 0, column_stride_ = 0;
};

} // namespace ciel
