// ValuesView: the values of a field, stored as floats or as doubles. Not in the paper, whose values are floats.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <limits>
#include <ranges>
#include <span>
#include <vector>

namespace ciel {

// View of an array of floats or of doubles; does not own the array. Returns each value as a double. A float becomes the
// equal double; a NaN keeps its payload.
class ValuesView {
public:
    class Iterator {
    public:
        using iterator_category = std::input_iterator_tag; // by C++17's rules, because operator* returns a value
        using iterator_concept = std::forward_iterator_tag;
        using value_type = double;
        using difference_type = std::ptrdiff_t;
        using pointer = void;
        using reference = double;

        Iterator() = default;
        Iterator(const ValuesView& of, std::size_t at) : values_(of.begin_), doubles_(of.doubles_), at_(at) {}
        double operator*() const { return ValuesView::at(values_, doubles_, at_); }
        Iterator& operator++() {
            ++at_;
            return *this;
        }
        Iterator operator++(int) {
            Iterator before = *this;
            ++at_;
            return before;
        }
        bool operator==(const Iterator&) const = default;

    private:
        const void* values_ = nullptr;
        bool doubles_ = false;
        std::size_t at_ = 0;
    };
    using value_type = double;
    using const_iterator = Iterator;

    ValuesView() = default;
    // NOLINTBEGIN(google-explicit-constructor): arrays of both types are values
    ValuesView(std::span<const float> values) : begin_(values.data()), size_(values.size()) {}
    ValuesView(std::span<const double> values) : begin_(values.data()), size_(values.size()), doubles_(true) {}
    template <std::ranges::contiguous_range Range>
    requires(!std::same_as<std::remove_cvref_t<Range>, ValuesView>) ValuesView(const Range& values)
        : ValuesView(std::span<const std::ranges::range_value_t<Range>>(values)) {}
    // NOLINTEND(google-explicit-constructor)

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] bool has_doubles() const { return doubles_; }
    [[nodiscard]] double operator[](std::size_t i) const { return at(begin_, doubles_, i); }
    [[nodiscard]] Iterator begin() const { return {*this, 0}; }
    [[nodiscard]] Iterator end() const { return {*this, size_}; }
    [[nodiscard]] const void* data() const { return begin_; }
    [[nodiscard]] std::size_t size_bytes() const { return size_ * (doubles_ ? sizeof(double) : sizeof(float)); }
    [[nodiscard]] std::span<const std::byte> bytes() const {
        return {static_cast<const std::byte*>(begin_), size_bytes()};
    }
    [[nodiscard]] std::span<const float> floats() const { // REQUIRES: !has_doubles()
        return {static_cast<const float*>(begin_), size_};
    }
    // REQUIRES: begin + count <= size().
    [[nodiscard]] ValuesView subview(std::size_t begin, std::size_t count) const {
        ValuesView part = *this;
        part.begin_ = bytes().data() + begin * (doubles_ ? sizeof(double) : sizeof(float));
        part.size_ = count;
        return part;
    }
    // Calls f with a span of floats or a span of doubles. Lets a loop test the type once instead of at each value.
    template <class F>
    decltype(auto) with(F&& f) const {
        return doubles_ ? f(std::span(static_cast<const double*>(begin_), size_))
                        : f(std::span(static_cast<const float*>(begin_), size_));
    }

private:
    static double at(const void* values, bool doubles, std::size_t i) {
        return doubles ? static_cast<const double*>(values)[i] : double{static_cast<const float*>(values)[i]};
    }

    const void* begin_ = nullptr;
    std::size_t size_ = 0;
    bool doubles_ = false;
};

// Returns whether each value is equal to some float. NaN and infinities are treated as equal to a float.
[[nodiscard]] inline bool are_floats(ValuesView values) {
    constexpr double largest = std::numeric_limits<float>::max();
    return !values.has_doubles() || std::ranges::all_of(values, [](double value) {
        if (!std::isfinite(value)) return true;
        return std::abs(value) <= largest && double{static_cast<float>(value)} == value;
    });
}

// Returns value - origin, rounded to float, for each value. If `origin` is near the values, small differences between
// values survive the rounding.
[[nodiscard]] inline std::vector<float> floats_from(double origin, ValuesView values) {
    std::vector<float> floats(values.size());
    for (std::size_t i = 0; i < floats.size(); ++i) floats[i] = static_cast<float>(values[i] - origin);
    return floats;
}

} // namespace ciel
