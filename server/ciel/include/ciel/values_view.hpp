// ValuesView: the values of a field as they are stored, floats or doubles. Not in the paper, whose values are floats.
#pragma once

#include <concepts>
#include <cstddef>
#include <ranges>
#include <span>

namespace ciel {

// Does not own the values.
class ValuesView {
public:
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
    [[nodiscard]] double operator[](std::size_t i) const {
        return doubles_ ? static_cast<const double*>(begin_)[i] : double{static_cast<const float*>(begin_)[i]};
    }
    // Calls f(span of floats) or f(span of doubles): for loops in which asking at each value would cost.
    template <class F>
    decltype(auto) with(F&& f) const {
        return doubles_ ? f(std::span(static_cast<const double*>(begin_), size_))
                        : f(std::span(static_cast<const float*>(begin_), size_));
    }

private:
    const void* begin_ = nullptr;
    std::size_t size_ = 0;
    bool doubles_ = false;
};

} // namespace ciel
