// StoredScalar: a scalar at one step, read from the dataset where it is needed. Has one number per vertex, or per cell
// or boundary face if its array is on these.
#pragma once

#include "ciel/extract.hpp"
#include "ciel/value_source.hpp"
#include "store/cache/paged_file.hpp"
#include "store/dataset.hpp"

#include <functional>

namespace ciel::store {

// Thread-safe. If another process rewrites the file, reads return other numbers; no index depends on them.
class StoredScalar final : public ValueSource {
public:
    // An item is a vertex, a cell or a boundary face. values: all components of `array`.
    StoredScalar(ArrayInfo array, ScalarName scalar, PagedValues values)
        : array_(std::move(array)), scalar_(std::move(scalar)), values_(std::move(values)),
          width_(static_cast<std::size_t>(array_.components)) {}

    [[nodiscard]] std::size_t size() const override { return values_.values.size() / width_; }
    [[nodiscard]] bool has_doubles() const override { return values_.values.has_doubles(); }
    void read(Index first, std::span<float> out) const override;
    void read(Index first, std::span<double> out) const override;
    void read(std::span<const Index> vertices, std::span<float> out) const override;
    void read(std::span<const Index> vertices, std::span<double> out) const override;

    // Return numbers of the scalar in the array's type. at: at the points of a surface, interpolated along their edges.
    // of: of `items`, no_value for `none`. all: of all items. Throw Error when the points or items are of another mesh,
    // and when the file was truncated meanwhile.
    [[nodiscard]] Values at(std::span<const EdgePoint> points) const;
    [[nodiscard]] Values of(std::span<const Index> items) const;
    [[nodiscard]] Values all() const;
    // Calls f(numbers) for one piece of all numbers after another, so that only a piece is in memory. Throws Error when
    // the file was truncated meanwhile.
    void for_pieces(const std::function<void(ValuesView)>& f) const;
    // Counts all numbers. `range`: the range of the bins; nullopt: that of the finite numbers, for which all are read
    // twice.
    [[nodiscard]] Histogram histogram(std::size_t bins, std::optional<std::array<double, 2>> range) const;

private:
    template <class T>
    void read_from(Index first, std::span<T> out) const;
    template <class T>
    void read_at(std::span<const Index> vertices, std::span<T> out) const;
    template <class T>
    [[nodiscard]] T value_of(Index vertex) const;
    void load(std::size_t first, std::size_t count) const;

    ArrayInfo array_;
    ScalarName scalar_;
    PagedValues values_;
    std::size_t width_; // numbers per item
};

} // namespace ciel::store
