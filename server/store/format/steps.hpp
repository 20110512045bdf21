// Steps: the steps of a dataset. Each step is read when it is first requested.
#pragma once

#include "store/format/dataset_info.hpp"

#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace server::store {

// The steps are in the order of ascending times. Thread-safe. A reference to a step is valid as long as this object
// exists. Functions that return a step throw Error when the step is damaged.
class Steps {
public:
    // `read`: reads and returns a step. Several threads may call it at the same time. `before`: the steps before a
    // refresh of the dataset, or null. Steps that `before` has already read are not read again, unless they have late
    // arrays.
    Steps(std::vector<double> times, std::function<Step(std::size_t)> read, const Steps* before);

    [[nodiscard]] std::size_t size() const { return times_.size(); }
    [[nodiscard]] bool empty() const { return times_.empty(); }
    [[nodiscard]] std::span<const double> times() const { return times_; } // reads no step
    [[nodiscard]] const Step& operator[](std::size_t step) const;
    [[nodiscard]] const Step& at(std::size_t step) const; // throws Error if there is no such step
    // Returns the indices of the steps that had late arrays when they were read.
    [[nodiscard]] std::vector<std::size_t> known_with_late_arrays() const;
    [[nodiscard]] const Step& front() const { return (*this)[0]; }
    [[nodiscard]] const Step& back() const { return (*this)[size() - 1]; }

    class Iterator {
    public:
        using value_type = Step;
        using difference_type = std::ptrdiff_t;

        Iterator() = default;
        Iterator(const Steps& of, std::size_t at) : of_(&of), at_(at) {}
        const Step& operator*() const { return (*of_)[at_]; }
        Iterator& operator++() {
            ++at_;
            return *this;
        }
        Iterator operator++(int) {
            Iterator before = *this;
            ++at_;
            return before;
        }
        bool operator==(const Iterator& other) const { return at_ == other.at_; }

    private:
        const Steps* of_ = nullptr;
        std::size_t at_ = 0;
    };
    [[nodiscard]] Iterator begin() const { return {*this, 0}; }
    [[nodiscard]] Iterator end() const { return {*this, size()}; }

private:
    std::vector<double> times_;
    std::function<Step(std::size_t)> read_;
    mutable std::mutex mutex_;
    mutable std::vector<std::shared_ptr<const Step>> known_; // by step; null until the step is read
};

} // namespace server::store
