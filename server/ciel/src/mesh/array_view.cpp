#include "ciel/array_view.hpp"

#include <cstring>

namespace ciel {

template <class T>
T ArrayView::at(std::size_t row, std::size_t column) const {
    T value;
    std::memcpy(&value,
                begin_ + static_cast<std::ptrdiff_t>(row) * row_stride_ +
                    static_cast<std::ptrdiff_t>(column) * column_stride_,
                sizeof(T)); // memcpy, because the element may be unaligned
    return value;
}

double ArrayView::real(std::size_t row, std::size_t column) const {
    if (type_ == NumberType::float32) return at<float>(row, column);
    if (type_ == NumberType::float64) return at<double>(row, column);
    if (type_ == NumberType::uint64) return static_cast<double>(at<std::uint64_t>(row, column));
    return static_cast<double>(integer(row, column));
}

std::int64_t ArrayView::integer(std::size_t row, std::size_t column) const {
    switch (type_) {
    case NumberType::uint8:
        return at<std::uint8_t>(row, column);
    case NumberType::int32:
        return at<std::int32_t>(row, column);
    case NumberType::uint32:
        return at<std::uint32_t>(row, column);
    case NumberType::int64:
    case NumberType::uint64:
        return at<std::int64_t>(row, column);
    case NumberType::float32:
    case NumberType::float64:
        break;
    }
    fail("an array of ids has numbers that are not integers; give it as 32-bit or 64-bit integers");
}

} // namespace ciel
