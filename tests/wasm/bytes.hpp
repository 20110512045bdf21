// Binary serialization in memory layout. All supported machines are little-endian.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace ciel::test {

using Bytes = std::vector<std::byte>;

// Writer and Reader have the same call operator, so one function can list the parts of a type for both. Counts are
// stored in 64 bits, because std::size_t has 32 bits in WebAssembly.
class Writer {
public:
    explicit Writer(Bytes& bytes) : bytes_(bytes) {}

    template <typename T>
    void operator()(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        append(&value, sizeof value);
    }
    template <typename T>
    void operator()(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        (*this)(std::uint64_t{values.size_bytes()});
        append(values.data(), values.size_bytes());
    }
    template <typename T>
    void operator()(const std::vector<T>& values) {
        (*this)(std::span<const T>(values));
    }
    void operator()(const std::string& text) { (*this)(std::span<const char>(text)); }

private:
    void append(const void* data, std::size_t size) {
        const auto* begin = static_cast<const std::byte*>(data);
        bytes_.insert(bytes_.end(), begin, begin + size);
    }

    Bytes& bytes_;
};

// Does not check the bytes, which a Writer of the same test has made.
class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}
    [[nodiscard]] bool at_end() const { return bytes_.empty(); }

    template <typename T>
    void operator()(T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        take(&value, sizeof value);
    }
    template <typename T>
    void operator()(std::vector<T>& values) {
        values.resize(size() / sizeof(T));
        take(values.data(), values.size() * sizeof(T));
    }
    void operator()(std::string& text) {
        text.resize(size());
        take(text.data(), text.size());
    }

private:
    std::size_t size() {
        std::uint64_t size = 0;
        (*this)(size);
        return static_cast<std::size_t>(size);
    }
    void take(void* data, std::size_t size) {
        if (size > 0) std::memcpy(data, bytes_.data(), size); // the data pointer of an empty array may be null
        bytes_ = bytes_.subspan(size);
    }

    std::span<const std::byte> bytes_;
};

} // namespace ciel::test
