#include "methods/cell_extremes.hpp"
#include "methods/progress.hpp"

namespace server::methods {

protocol::DatasetHistogramResult dataset_histogram(CallContext& context,
                                                   const protocol::DatasetHistogramParams& params) {
    const std::size_t limit = context.server.limits().histogram_bins;
    if (params.bins > static_cast<std::int64_t>(limit))
        throw limits::LimitReached("a histogram may have at most " + std::to_string(limit) +
                                   " bins; ask for fewer bins");
    if (params.range && !((*params.range)[0] < (*params.range)[1]))
        throw InvalidParams("/range", "/range must be [minimum, maximum] with minimum < maximum");
    const auto loaded = context.dataset(params.dataset);
    const auto dataset = loaded->dataset();
    if (dataset->steps().empty()) throw ciel::Error(params.dataset + " has no time step yet; append a step");
    const store::ScalarName name = [&] {
        try {
            return store::parse_scalar(*dataset, params.array);
        } catch (const ciel::Error& error) {
            throw limits::NotFound(error.what());
        }
    }();
    const std::size_t step = params.time ? dataset->step_at(*params.time) : 0;
    Progress progress(context, params.progress, std::nullopt);
    const auto values_read = [&](std::size_t done, std::size_t of) {
        context.check_wanted();
        progress.count("measuring", done, of);
    };
    progress.begin("measuring");
    const store::Histogram histogram =
        loaded->histogram(params.array, step, static_cast<std::size_t>(params.bins), params.range, values_read);
    protocol::DatasetHistogramResult result;
    result.range = histogram.range;
    result.counts.assign(histogram.counts.begin(), histogram.counts.end());
    result.below = static_cast<std::int64_t>(histogram.below);
    result.above = static_cast<std::int64_t>(histogram.above);
    result.invalid = static_cast<std::int64_t>(histogram.invalid);
    result.cells = answer_of(store::cell_extremes(*dataset, params.array, step));
    return result;
}

} // namespace server::methods
