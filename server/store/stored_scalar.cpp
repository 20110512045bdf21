#include "store/stored_scalar.hpp"

#include "ciel/parallel.hpp"
#include "ciel/vector_operators.hpp"

namespace ciel::store {

void StoredScalar::load(std::size_t first, std::size_t count) const {
    const std::size_t bytes = width_ * (has_doubles() ? sizeof(double) : sizeof(float));
    values_.file->load(first * bytes, (first + count) * bytes);
}

template <class T>
void StoredScalar::read_from(Index first, std::span<T> out) const {
    load(first, out.size());
    const auto* begin = static_cast<const T*>(values_.values.data()) + first * width_;
    scalars_in(array_, std::span(begin, out.size() * width_), scalar_, out);
}

template <class T>
T StoredScalar::value_of(Index vertex) const {
    T value;
    read_from(vertex, std::span(&value, 1));
    return value;
}

template <class T>
void StoredScalar::read_at(std::span<const Index> vertices, std::span<T> out) const {
    const auto* all = static_cast<const T*>(values_.values.data());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        load(vertices[i], 1);
        out[i] = width_ == 1 ? all[vertices[i]] : value_of<T>(vertices[i]);
    }
}

void StoredScalar::read(Index first, std::span<float> out) const { read_from(first, out); }
void StoredScalar::read(Index first, std::span<double> out) const { read_from(first, out); }
void StoredScalar::read(std::span<const Index> vertices, std::span<float> out) const { read_at(vertices, out); }
void StoredScalar::read(std::span<const Index> vertices, std::span<double> out) const { read_at(vertices, out); }

Values StoredScalar::at(std::span<const EdgePoint> points) const {
    const auto in = [&]<class T>(std::vector<T> out) {
        parallel_for(points.size(), 16384, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto& [a, b, t] = points[i];
                if (a >= size() || b >= size()) throw Error("the surface belongs to another mesh than the values");
                out[i] = lerp(value_of<T>(a), value_of<T>(b), t);
            }
        });
        values_.file->file().check_intact();
        return Values(std::move(out));
    };
    return has_doubles() ? in(std::vector<double>(points.size())) : in(std::vector<float>(points.size()));
}

Values StoredScalar::all() const {
    values_.file->load_all();
    Values copied = one_scalar(array_, values_.values, scalar_);
    values_.file->file().check_intact();
    return copied;
}

} // namespace ciel::store
