// CheckedArray: a view of an array of indices in a mapped file, which another process may change at any time. Every
// index that it returns is in range, whatever the file contains. Not in the paper.
#pragma once

#include "ciel/types.hpp"

#include <compare>
#include <cstddef>
#include <iterator>
#include <span>

namespace ciel {

// Reports a damaged array. The owner of a mapped array implements this class with a message that names the file.
class ArrayKeeper {
public:
    ArrayKeeper() = default;
    ArrayKeeper(const ArrayKeeper&) = default;
    ArrayKeeper& operator=(const ArrayKeeper&) = default;
    virtual ~ArrayKeeper() = default;
    // Throws Error with a message that names the damaged array. Any thread may call it.
    [[noreturn]] virtual void refuse() const = 0;
};

// Calls keeper->refuse(). If `keeper` is null, throws Error with a message about a damaged mesh.
[[noreturn]] void refuse_array(const ArrayKeeper* keeper);

// View of an array of indices, like std::span: owns neither the array nor the keeper. In a FaceMeshView, keep_alive
// owns both. Any thread may read. Each access reads the memory once and checks the value. If the value is out of range,
// the access throws the keeper's Error. Two accesses to the same entry may return different values; copy an entry that
// is used twice.
template <class T, bool may_be_none = false>
class CheckedArray {
public:
    using value_type = T;
    class const_iterator; // random access; dereferencing returns a value, not a reference
    using iterator = const_iterator;

    CheckedArray() = default;
    // An entry is valid if it is below `limit`. If `may_be_none` is true, `none` is valid too.
    CheckedArray(std::span<const T> entries, T limit, const ArrayKeeper* keeper = nullptr)
        : data_(entries.data()), size_(entries.size()), limit_(limit), keeper_(keeper) {}

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] T operator[](std::size_t i) const { return read(data_ + i); }
    [[nodiscard]] T front() const { return read(data_); }
    [[nodiscard]] const_iterator begin() const { return {data_, *this}; }
    [[nodiscard]] const_iterator end() const { return {data_ + size_, *this}; }
    // REQUIRES: begin + count <= size()
    [[nodiscard]] CheckedArray part(std::size_t begin, std::size_t count) const {
        return {std::span(data_ + begin, count), limit_, keeper_};
    }
    // Returns the entries without checks, for code that checks the array itself.
    [[nodiscard]] std::span<const T> unchecked() const { return {data_, size_}; }
    // Throws the keeper's Error. For callers that find two entries which contradict each other.
    [[noreturn]] void refuse() const { refuse_array(keeper_); }

private:
    [[nodiscard]] T read(const T* at) const {
        // volatile, because the compiler must not read the memory twice
        const T entry = *const_cast<const volatile T*>(at);
        const bool holds = may_be_none ? static_cast<T>(entry + 1) <= limit_ : entry < limit_;
        if (!holds) [[unlikely]]
            refuse_array(keeper_);
        return entry;
    }

    const T* data_ = nullptr;
    std::size_t size_ = 0;
    T limit_ = 0;
    const ArrayKeeper* keeper_ = nullptr;
};

template <class T, bool may_be_none>
class CheckedArray<T, may_be_none>::const_iterator {
public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = const T*;
    using reference = T;

    const_iterator() = default;
    const_iterator(const T* at, const CheckedArray& of) : at_(at), limit_(of.limit_), keeper_(of.keeper_) {}

    T operator*() const { return CheckedArray({at_, 1}, limit_, keeper_).front(); }
    T operator[](difference_type n) const { return *(*this + n); }
    const_iterator& operator+=(difference_type n) {
        at_ += n;
        return *this;
    }
    const_iterator& operator-=(difference_type n) { return *this += -n; }
    const_iterator& operator++() { return *this += 1; }
    const_iterator& operator--() { return *this += -1; }
    const_iterator operator++(int) {
        const const_iterator before = *this;
        ++*this;
        return before;
    }
    const_iterator operator--(int) {
        const const_iterator before = *this;
        --*this;
        return before;
    }
    friend const_iterator operator+(const_iterator at, difference_type n) { return at += n; }
    friend const_iterator operator+(difference_type n, const_iterator at) { return at += n; }
    friend const_iterator operator-(const_iterator at, difference_type n) { return at -= n; }
    friend difference_type operator-(const const_iterator& a, const const_iterator& b) { return a.at_ - b.at_; }
    friend bool operator==(const const_iterator& a, const const_iterator& b) { return a.at_ == b.at_; }
    friend auto operator<=>(const const_iterator& a, const const_iterator& b) { return a.at_ <=> b.at_; }

private:
    const T* at_ = nullptr;
    T limit_ = 0;
    const ArrayKeeper* keeper_ = nullptr;
};

using Ids = CheckedArray<Index>;
using OptionalIds = CheckedArray<Index, true>; // ids that may be `none`

} // namespace ciel
