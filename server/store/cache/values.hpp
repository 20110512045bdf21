// Values: an array at one step, as a dataset gives it.
#pragma once

#include <memory>
#include <span>

namespace ciel::store {

// The numbers stay where they are as long as the object or a copy of it lives. They may change while another process
// rewrites the file (Dataset).
class Values {
public:
    using value_type = float;
    using const_iterator = const float*;

    Values() = default;
    Values(std::span<const float> numbers, std::shared_ptr<const void> keep_alive)
        : numbers_(numbers), keep_alive_(std::move(keep_alive)) {}

    [[nodiscard]] const float* data() const { return numbers_.data(); }
    [[nodiscard]] const float* begin() const { return data(); }
    [[nodiscard]] const float* end() const { return data() + size(); }
    [[nodiscard]] std::size_t size() const { return numbers_.size(); }
    [[nodiscard]] std::size_t size_bytes() const { return numbers_.size_bytes(); }
    [[nodiscard]] bool empty() const { return numbers_.empty(); }
    [[nodiscard]] float operator[](std::size_t i) const { return numbers_[i]; }
    [[nodiscard]] std::span<const float> subspan(std::size_t begin, std::size_t count) const {
        return numbers_.subspan(begin, count);
    }
    [[nodiscard]] std::shared_ptr<const void> keep_alive() const { return keep_alive_; }

private:
    std::span<const float> numbers_;
    std::shared_ptr<const void> keep_alive_;
};

} // namespace ciel::store
