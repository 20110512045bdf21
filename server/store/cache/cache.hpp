// Cache: a least-recently-used cache. It limits the total bytes of the values and the number of values, but always
// keeps the most recently used value. Thread-safe.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

namespace server::store {

class Cache {
public:
    struct Made {
        std::shared_ptr<const void> value;
        std::size_t bytes = 0;
    };

    explicit Cache(std::size_t budget_bytes, std::size_t most_values = std::numeric_limits<std::size_t>::max())
        : budget_(budget_bytes), most_(most_values) {}

    // Returns the cached value of `key`, or calls `make` and caches the result. Threads that request the same key wait
    // for one call of `make`. A value exists as long as a caller holds it, even after the cache has dropped it.
    template <typename T>
    [[nodiscard]] std::shared_ptr<const T> get(const std::string& key, const std::function<Made()>& make) {
        return std::static_pointer_cast<const T>(get_erased(key, make));
    }
    [[nodiscard]] std::size_t bytes() const;
    // Drops all values that no caller holds, except the most recently used one.
    void drop_unused();

private:
    struct Slot {
        std::mutex making;
        Made made;
    };
    struct Entry {
        std::shared_ptr<Slot> slot;
        std::list<std::string>::iterator age;
        std::size_t bytes = 0;
    };

    [[nodiscard]] std::shared_ptr<const void> get_erased(const std::string& key, const std::function<Made()>& make);
    [[nodiscard]] std::shared_ptr<Slot> slot(const std::string& key);
    void account(const std::string& key, const Slot& slot);
    // REQUIRES: mutex_ is locked. The caller destroys the result after the unlock, because destroying a value may take
    // long.
    [[nodiscard]] std::shared_ptr<Slot> drop(std::list<std::string>::iterator key);

    mutable std::mutex mutex_;
    std::size_t budget_, most_, bytes_ = 0;
    std::list<std::string> ages_; // keys, the most recently used first
    std::unordered_map<std::string, Entry> entries_;
};

} // namespace server::store
