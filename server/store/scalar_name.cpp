// Names of scalars: an array, or one component or the magnitude of a vector.
#include "ciel/printable.hpp"
#include "store/dataset.hpp"

#include <algorithm>

namespace ciel::store {
namespace {

std::string component_name(const ArrayInfo& array, int component) {
    if (array.components <= 3) return std::string(1, "xyz"[component]);
    return std::to_string(component);
}

std::optional<ScalarName> parse_suffix(const ArrayInfo& array, const std::string& suffix) {
    if (suffix == "magnitude") return ScalarName{array.name, std::nullopt, true};
    for (int c = 0; c < array.components; ++c)
        if (suffix == component_name(array, c) || suffix == std::to_string(c)) return ScalarName{array.name, c, false};
    return std::nullopt;
}

} // namespace

std::vector<std::string> scalar_names(const ArrayInfo& array) {
    if (array.components == 1) return {array.name};
    std::vector<std::string> names{array.name + ":magnitude"};
    for (int c = 0; c < array.components; ++c) names.push_back(array.name + ":" + component_name(array, c));
    return names;
}

ScalarName parse_scalar(const Dataset& dataset, const std::string& name) {
    // A vector's bare name is its magnitude: what most people mean who colour by U.
    if (const ArrayInfo* array = dataset.find(name)) return {array->name, std::nullopt, array->components > 1};
    if (const auto colon = name.rfind(':'); colon != std::string::npos)
        if (const ArrayInfo* array = dataset.find(name.substr(0, colon)); array != nullptr && array->components > 1)
            if (auto scalar = parse_suffix(*array, name.substr(colon + 1))) return *scalar;
    std::string names;
    for (const ArrayInfo& array : dataset.info().arrays) {
        if (array.association == Association::cell) continue;
        for (const std::string& each : scalar_names(array)) names += (names.empty() ? "" : ", ") + each;
    }
    throw Error("dataset '" + dataset.info().name + "' has no scalar '" + printable(name) + "'; it has " +
                (names.empty() ? std::string("none") : names));
}

} // namespace ciel::store
