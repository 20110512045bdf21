// SparseArray: an array for all vertices of a mesh. In a large array, only elements that were used take memory. Not in
// the paper.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

namespace ciel::detail {

// Returns zeroed memory. Large requests take memory only where it is touched. Throws std::bad_alloc.
[[nodiscard]] void* reserve_zeroed(std::size_t bytes);
void release_zeroed(void* begin, std::size_t bytes); // begin: the result of reserve_zeroed(bytes)

// All elements are zero at first. Not thread-safe, but several threads may use different elements at the same time.
template <class T>
requires std::is_trivially_copyable_v<T>
class SparseArray {
public:
    SparseArray() = default;
    explicit SparseArray(std::size_t size)
        : begin_(static_cast<T*>(reserve_zeroed(size * sizeof(T))), Release{size * sizeof(T)}), size_(size) {}
    SparseArray(SparseArray&& other) noexcept : begin_(std::move(other.begin_)), size_(std::exchange(other.size_, 0)) {}
    SparseArray& operator=(SparseArray&& other) noexcept {
        begin_ = std::move(other.begin_);
        size_ = std::exchange(other.size_, 0);
        return *this;
    }
    SparseArray(const SparseArray&) = delete;
    SparseArray& operator=(const SparseArray&) = delete;
    ~SparseArray() = default;

    [[nodiscard]] T* get() const { return begin_.get(); } // null if constructed without a size
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::span<T> all() const { return {begin_.get(), size_}; }

private:
    struct Release {
        std::size_t bytes = 0;
        void operator()(T* begin) const { release_zeroed(begin, bytes); }
    };
    std::unique_ptr<T[], Release> begin_{nullptr, Release{}};
    std::size_t size_ = 0;
};

} // namespace ciel::detail
