// Touched: views of blocks, each made when its block is first used. Not in the paper.
#pragma once

#include "ciel/threads.hpp"

#include <array>
#include <atomic>
#include <memory>

namespace ciel::detail {

// Thread-safe.
template <class View>
class Touched {
public:
    Touched() = default;
    Touched(const Touched&) = delete;
    Touched& operator=(const Touched&) = delete;
    ~Touched() {
        for (std::size_t b = 0; b < size_; ++b) delete views_[b].load(std::memory_order_relaxed);
    }

    // Sets the number of blocks. Call it before all other functions.
    void resize(std::size_t blocks) {
        views_ = std::make_unique<std::atomic<const View*>[]>(blocks);
        size_ = blocks;
    }
    [[nodiscard]] std::size_t size() const { return size_; }
    // Returns the view of the block. The first call makes the view with make(). If make() throws, this function throws
    // the same exception, and a later call tries again.
    template <class Make>
    [[nodiscard]] const View& of(std::size_t block, Make&& make) const {
        if (const View* const made = views_[block].load(std::memory_order_acquire); made != nullptr) [[likely]]
            return *made;
        return touch(block, make);
    }
    // Deletes the view of the block. The caller ensures that no thread uses the view.
    void drop(std::size_t block) { delete views_[block].exchange(nullptr); }
    template <class F>
    void for_each(F&& f) const {
        for (std::size_t b = 0; b < size_; ++b)
            if (const View* const made = views_[b].load(std::memory_order_acquire); made != nullptr) f(*made);
    }

private:
    template <class Make>
    const View& touch(std::size_t block, Make& make) const {
        const Locked lock(making_[block % making_.size()]);
        if (const View* const made = views_[block].load(std::memory_order_relaxed); made != nullptr) return *made;
        auto made = std::make_unique<const View>(make());
        views_[block].store(made.get(), std::memory_order_release);
        return *made.release();
    }

    std::size_t size_ = 0;
    std::unique_ptr<std::atomic<const View*>[]> views_;
    mutable std::array<Mutex, 16> making_;
};

} // namespace ciel::detail
