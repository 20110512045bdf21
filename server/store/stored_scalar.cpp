#include "store/stored_scalar.hpp"

#include "ciel/parallel.hpp"
#include "ciel/vector_operators.hpp"
#include "store/cache/stored_array.hpp"
#include "store/no_value.hpp"

namespace server::store {

namespace {

[[noreturn]] void refuse_other_mesh() { throw ciel::Error("the surface belongs to another mesh than the values"); }

} // namespace

void StoredScalar::load(std::size_t first, std::size_t count) const {
    const std::size_t bytes = width_ * (has_doubles() ? sizeof(double) : sizeof(float));
    values_.file->load(first * bytes, (first + count) * bytes);
}

template <class T>
void StoredScalar::read_from(ciel::Index first, std::span<T> out) const {
    load(first, out.size());
    const auto* begin = static_cast<const T*>(values_.values.data()) + first * width_;
    scalars_in(array_, std::span(begin, out.size() * width_), scalar_, out);
}

template <class T>
T StoredScalar::value_of(ciel::Index vertex) const {
    T value;
    read_from(vertex, std::span(&value, 1));
    return value;
}

template <class T>
void StoredScalar::read_at(std::span<const ciel::Index> vertices, std::span<T> out) const {
    const auto* all = static_cast<const T*>(values_.values.data());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        load(vertices[i], 1);
        out[i] = width_ == 1 ? all[vertices[i]] : value_of<T>(vertices[i]);
    }
}

void StoredScalar::read(ciel::Index first, std::span<float> out) const { read_from(first, out); }
void StoredScalar::read(ciel::Index first, std::span<double> out) const { read_from(first, out); }
void StoredScalar::read(std::span<const ciel::Index> vertices, std::span<float> out) const { read_at(vertices, out); }
void StoredScalar::read(std::span<const ciel::Index> vertices, std::span<double> out) const { read_at(vertices, out); }

Values StoredScalar::at(std::span<const ciel::EdgePoint> points) const {
    const auto in = [&]<class T>(std::vector<T> out) {
        ciel::parallel_for(points.size(), 16384, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto& [a, b, t] = points[i];
                if (a >= size() || b >= size()) refuse_other_mesh();
                out[i] = ciel::lerp(value_of<T>(a), value_of<T>(b), t);
            }
        });
        values_.file->file().check_intact();
        return Values(std::move(out));
    };
    return has_doubles() ? in(std::vector<double>(points.size())) : in(std::vector<float>(points.size()));
}

Values StoredScalar::of(std::span<const ciel::Index> items) const {
    const auto in = [&]<class T>(std::vector<T> out) {
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (items[i] == ciel::none) continue;
            if (items[i] >= size()) refuse_other_mesh();
            read_at(items.subspan(i, 1), std::span(out).subspan(i, 1));
        }
        values_.file->file().check_intact();
        return Values(std::move(out));
    };
    return has_doubles() ? in(std::vector<double>(items.size(), no_value))
                         : in(std::vector<float>(items.size(), no_value));
}

void StoredScalar::for_pieces(const std::function<void(ciel::ValuesView)>& f) const {
    const auto in = [&]<class T>(std::vector<T> piece) {
        for (std::size_t first = 0; first < size(); first += piece.size()) {
            const auto part = std::span(piece).first(std::min(piece.size(), size() - first));
            read_from(static_cast<ciel::Index>(first), part);
            f(part);
        }
    };
    constexpr std::size_t numbers = 16384;
    has_doubles() ? in(std::vector<double>(numbers)) : in(std::vector<float>(numbers));
    values_.file->file().check_intact();
}

Histogram StoredScalar::histogram(std::size_t bins, std::optional<std::array<double, 2>> range,
                                  const ValuesRead& values_read) const {
    const std::size_t all = (range ? 1 : 2) * size();
    std::size_t done = 0;
    const auto add_all_to = [&](auto& sum) {
        for_pieces([&](ciel::ValuesView piece) {
            sum.add(piece);
            done += piece.size();
            if (values_read) values_read(done, all);
        });
    };
    FiniteRange finite;
    if (!range) add_all_to(finite);
    Histogram histogram(range ? *range : finite.get(), bins);
    add_all_to(histogram);
    return histogram;
}

Values StoredScalar::all() const {
    Values of_array = loaded(values_);
    Values of_scalar = array_.components == 1 ? std::move(of_array) : one_scalar(array_, of_array, scalar_);
    values_.file->file().check_intact();
    return of_scalar;
}

} // namespace server::store
