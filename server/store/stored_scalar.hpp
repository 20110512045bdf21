// StoredScalar: a scalar at one step, with one value for each vertex, cell or boundary face, read when needed.
#pragma once

#include "ciel/extract.hpp"
#include "ciel/value_source.hpp"
#include "store/cache/checked_file.hpp"
#include "store/dataset.hpp"

#include <functional>

namespace server::store {

// Called after each piece of a long read: `done` of `of` values are read. An exception ends the read.
using ValuesRead = std::function<void(std::size_t done, std::size_t of)>;

// Thread-safe. If another process rewrites the file, a read returns other values or throws Error (checked_file.hpp).
// Other values are safe, because values are never used as indices.
class StoredScalar final : public ciel::ValueSource {
public:
    // values: all components of `array`, for all items.
    StoredScalar(ArrayInfo array, ScalarName scalar, ValuesToLoad values)
        : array_(std::move(array)), scalar_(std::move(scalar)), values_(std::move(values)),
          width_(static_cast<std::size_t>(array_.components)) {}

    [[nodiscard]] std::size_t size() const override { return values_.values.size() / width_; }
    [[nodiscard]] bool has_doubles() const override { return values_.values.has_doubles(); }
    void read(ciel::Index first, std::span<float> out) const override;
    void read(ciel::Index first, std::span<double> out) const override;
    void read(std::span<const ciel::Index> vertices, std::span<float> out) const override;
    void read(std::span<const ciel::Index> vertices, std::span<double> out) const override;

    // Return values of the scalar in the array's type. at: the values at the points of a surface, interpolated along
    // edges. of: the values of `items`; no_value where the item is `none`. all: the values of all items. If the array
    // has one component, `all` copies nothing: call Dataset::check_intact after the use of its result. Throw Error when
    // the points or items are of another mesh, and when the file was truncated meanwhile.
    [[nodiscard]] Values at(std::span<const ciel::EdgePoint> points) const;
    [[nodiscard]] Values of(std::span<const ciel::Index> items) const;
    [[nodiscard]] Values all() const;
    [[nodiscard]] bool copies_all() const { return array_.components > 1; } // whether `all` copies the values
    // Only one piece of the values is in memory at a time. Throws Error when the file was truncated meanwhile.
    void for_pieces(const std::function<void(ciel::ValuesView)>& f) const;
    // `range`: the range of the bins. nullopt: the range of the finite values; all values are then read twice.
    [[nodiscard]] Histogram histogram(std::size_t bins, std::optional<std::array<double, 2>> range,
                                      const ValuesRead& values_read = {}) const;

private:
    template <class T>
    void read_from(ciel::Index first, std::span<T> out) const;
    template <class T>
    void read_at(std::span<const ciel::Index> vertices, std::span<T> out) const;
    template <class T>
    [[nodiscard]] T value_of(ciel::Index vertex) const;
    void load(std::size_t first, std::size_t count) const;

    ArrayInfo array_;
    ScalarName scalar_;
    ValuesToLoad values_;
    std::size_t width_; // number of components of an item
};

} // namespace server::store
