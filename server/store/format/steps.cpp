#include "store/format/steps.hpp"

#include <algorithm>
#include <string>

namespace server::store {

Steps::Steps(std::vector<double> times, std::function<Step(std::size_t)> read, const Steps* before)
    : times_(std::move(times)), read_(std::move(read)), known_(times_.size()) {
    if (before == nullptr) return;
    const std::lock_guard lock(before->mutex_);
    const auto is_late = [](const auto& array) { return array.second.late; };
    for (std::size_t step = 0; step < std::min(before->known_.size(), known_.size()); ++step)
        if (const auto& known = before->known_[step]; known && std::ranges::none_of(known->arrays, is_late))
            known_[step] = known;
}

const Step& Steps::operator[](std::size_t step) const {
    {
        const std::lock_guard lock(mutex_);
        if (known_[step]) return *known_[step];
    }
    // read_ is called without the lock, because it can take long: it may compute the ranges of arrays.
    auto read = std::make_shared<const Step>(read_(step));
    const std::lock_guard lock(mutex_);
    if (!known_[step]) known_[step] = std::move(read);
    return *known_[step];
}

std::vector<std::size_t> Steps::known_with_late_arrays() const {
    std::vector<std::size_t> found;
    const std::lock_guard lock(mutex_);
    for (std::size_t step = 0; step < known_.size(); ++step)
        if (known_[step] &&
            std::ranges::any_of(known_[step]->arrays, [](const auto& array) { return array.second.late; }))
            found.push_back(step);
    return found;
}

const Step& Steps::at(std::size_t step) const {
    if (step >= size())
        throw ciel::Error("the dataset has " + std::to_string(size()) + " steps, numbered from 0; there is no step " +
                          std::to_string(step));
    return (*this)[step];
}

} // namespace server::store
