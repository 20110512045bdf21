#include "methods/cell_extremes.hpp"

#include <cmath>

namespace ciel::methods {
namespace {

std::array<double, 2> finite_range(ValuesView values) {
    std::array<double, 2> range{INFINITY, -INFINITY};
    for (const double value : values)
        if (std::isfinite(value)) range = {std::min(range[0], value), std::max(range[1], value)};
    if (range[0] > range[1]) return {0, 0};
    return range;
}

// Counts values into the bins of result.range. A bin is [low, high); the last one includes its upper end.
void count(protocol::DatasetHistogramResult& result, ValuesView values) {
    const auto [low, high] = result.range;
    const auto bins = static_cast<double>(result.counts.size());
    const double scale = std::isfinite(high - low) ? 1 : 0.5; // the width of the widest ranges overflows a double
    const double width = high * scale - low * scale;
    for (const double value : values) {
        if (!std::isfinite(value))
            ++result.invalid;
        else if (value < low)
            ++result.below;
        else if (value > high)
            ++result.above;
        else {
            const double place = width > 0 ? (value * scale - low * scale) / width * bins : 0;
            ++result.counts[static_cast<std::size_t>(std::min(place, bins - 1))];
        }
    }
}

store::Values values_of(store::LoadedDataset& loaded, store::Association association, const std::string& scalar,
                        std::size_t step) {
    switch (association) {
    case store::Association::point:
        break;
    case store::Association::cell:
        return loaded.cell_values(scalar, step);
    case store::Association::boundary_face:
        return loaded.face_values(scalar, step);
    }
    return loaded.scalar_values(scalar, step);
}

} // namespace

protocol::DatasetHistogramResult dataset_histogram(Context& context, const protocol::DatasetHistogramParams& params) {
    const std::size_t limit = context.server.limits().histogram_bins;
    if (params.bins > static_cast<std::int64_t>(limit))
        throw limits::LimitReached("a histogram may have at most " + std::to_string(limit) + " bins");
    if (params.range && !((*params.range)[0] < (*params.range)[1]))
        throw InvalidParams("/range", "/range must be [minimum, maximum] with minimum < maximum");
    const auto loaded = context.dataset(params.dataset);
    const auto dataset = loaded->dataset();
    if (dataset->steps().empty()) throw Error(params.dataset + " has no time step yet; append a step");
    const store::ScalarName name = [&] {
        try {
            return store::parse_scalar(*dataset, params.array);
        } catch (const Error& error) {
            throw limits::NotFound(error.what());
        }
    }();
    const std::size_t step = params.time ? dataset->step_at(*params.time) : 0;
    const auto values = values_of(*loaded, dataset->find(name.array)->association, params.array, step);
    protocol::DatasetHistogramResult result;
    result.range = params.range ? *params.range : finite_range(values);
    result.counts.assign(static_cast<std::size_t>(params.bins), 0);
    count(result, values);
    result.cells = answer_of(store::cell_extremes(*dataset, params.array, step));
    return result;
}

} // namespace ciel::methods
