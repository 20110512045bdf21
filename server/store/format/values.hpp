// Values: the numbers of an array at one step, floats or doubles.
#pragma once

#include "ciel/values_view.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace server::store {

// Keeps the numbers alive. Numbers in a mapped file may change when another process rewrites the file (see Dataset).
class Values : public ciel::ValuesView {
public:
    Values() = default;
    Values(ciel::ValuesView numbers, std::shared_ptr<const void> keep_alive)
        : ciel::ValuesView(numbers), keep_alive_(std::move(keep_alive)) {}
    // T: float or double.
    template <class T>
    explicit Values(std::vector<T>&& own) : Values(std::make_shared<const std::vector<T>>(std::move(own))) {}

    [[nodiscard]] const std::shared_ptr<const void>& keep_alive() const { return keep_alive_; }

private:
    template <class T>
    explicit Values(const std::shared_ptr<const std::vector<T>>& own) : ciel::ValuesView(*own), keep_alive_(own) {}

    std::shared_ptr<const void> keep_alive_;
};

// Returns the values as doubles, or as the nearest floats if `to_doubles` is false. If the values have that type
// already, they are not copied, and the array of `values` must outlive the result.
[[nodiscard]] inline Values converted(ciel::ValuesView values, bool to_doubles) {
    if (values.has_doubles() == to_doubles) return {values, nullptr};
    return values.with([&](auto all) {
        if (to_doubles) return Values(std::vector<double>(all.begin(), all.end()));
        std::vector<float> floats(all.size());
        std::ranges::transform(all, floats.begin(), [](auto value) { return static_cast<float>(value); });
        return Values(std::move(floats));
    });
}

} // namespace server::store
