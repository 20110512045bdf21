// The slot of a View for the newest scene. A newer value replaces a value that was not taken, so a scene may be
// skipped.
#pragma once

#include <optional>
#include <utility>

namespace server::engine {

// A Mailbox is not thread-safe; its owner locks it.
template <class T>
class Mailbox {
public:
    void put(T value) { slot_ = std::move(value); }
    [[nodiscard]] bool empty() const { return !slot_; }
    [[nodiscard]] std::optional<T> take() { return std::exchange(slot_, std::nullopt); }
    [[nodiscard]] const T& peek() const { return *slot_; } // requires !empty()

private:
    std::optional<T> slot_;
};

} // namespace server::engine
