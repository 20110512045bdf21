// Makes and parses the names of scalars.
#include "ciel/printable.hpp"
#include "store/dataset.hpp"
#include "store/no_value.hpp"

#include <algorithm>

namespace server::store {
namespace {

std::string component_name(const ArrayInfo& array, int component) {
    if (!array.component_names.empty()) return array.component_names[static_cast<std::size_t>(component)];
    if (array.components <= 3) return std::string(1, "xyz"[component]);
    return std::to_string(component);
}

// Components with names cannot be chosen by number, because file formats order the components differently.
std::optional<ScalarName> parse_suffix(const ArrayInfo& array, const std::string& suffix) {
    if (suffix == "magnitude" && has_magnitude(array)) return ScalarName{array.name, std::nullopt, true};
    for (int c = 0; c < array.components; ++c)
        if (suffix == component_name(array, c) || (array.component_names.empty() && suffix == std::to_string(c)))
            return ScalarName{array.name, c, false};
    return std::nullopt;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

// Splits "NAME:SUFFIX". Returns a null array unless `name` has this form and the array NAME has several components.
std::pair<const ArrayInfo*, std::string> split(const Dataset& dataset, const std::string& name) {
    if (const auto colon = name.rfind(':'); colon != std::string::npos)
        if (const ArrayInfo* array = dataset.find(name.substr(0, colon)); array != nullptr && array->components > 1)
            return {array, name.substr(colon + 1)};
    return {nullptr, {}};
}

// Weight in the Frobenius norm. A symmetric tensor has six components; off-diagonal ones appear twice in the matrix.
double weight(const ArrayInfo& array, std::size_t component) {
    if (array.component_names.size() != 6) return 1;
    const std::string& name = array.component_names[component];
    return name.size() == 2 && name[0] != name[1] ? 2 : 1;
}

template <class Tuple>
double magnitude_in(const ArrayInfo& array, const Tuple& tuple) {
    double squares = 0;
    for (std::size_t c = 0; c < tuple.size(); ++c) squares += weight(array, c) * (double{tuple[c]} * tuple[c]);
    return std::sqrt(squares);
}

template <class T>
T scalar_in(const ArrayInfo& array, std::span<const T> tuple, const ScalarName& scalar) {
    if (scalar.component) return tuple[static_cast<std::size_t>(*scalar.component)];
    if (!scalar.magnitude) return tuple[0];
    if (std::ranges::any_of(tuple, is_no_value)) return static_cast<T>(no_value);
    return static_cast<T>(magnitude_in(array, tuple));
}

template <class T>
void all_in(const ArrayInfo& array, std::span<const T> tuples, const ScalarName& scalar, std::span<T> out) {
    const auto width = static_cast<std::size_t>(array.components);
    if (width == 1) {
        std::ranges::copy(tuples, out.begin());
        return;
    }
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = scalar_in(array, tuples.subspan(i * width, width), scalar);
}

} // namespace

void scalars_in(const ArrayInfo& array, std::span<const float> tuples, const ScalarName& scalar, std::span<float> out) {
    all_in(array, tuples, scalar, out);
}

void scalars_in(const ArrayInfo& array, std::span<const double> tuples, const ScalarName& scalar,
                std::span<double> out) {
    all_in(array, tuples, scalar, out);
}

bool has_magnitude(const ArrayInfo& array) {
    return array.components == 2 || array.components == 3 || !array.component_names.empty();
}

double magnitude_of(const ArrayInfo& array, ciel::ValuesView tuple) { return magnitude_in(array, tuple); }

Values one_scalar(const ArrayInfo& array, ciel::ValuesView values, const ScalarName& scalar) {
    const auto components = static_cast<std::size_t>(array.components);
    return values.with([&]<class T>(std::span<const T> all) {
        std::vector<T> result(all.size() / components);
        scalars_in(array, all, scalar, std::span(result));
        return Values(std::move(result));
    });
}

std::vector<ScalarName> scalars_of(const ArrayInfo& array) {
    if (array.components == 1) return {{array.name, std::nullopt, false}};
    std::vector<ScalarName> scalars;
    if (has_magnitude(array)) scalars.push_back({array.name, std::nullopt, true});
    for (int c = 0; c < array.components; ++c) scalars.push_back({array.name, c, false});
    return scalars;
}

std::vector<std::string> scalar_names(const ArrayInfo& array) {
    if (array.components == 1) return {array.name};
    std::vector<std::string> names;
    if (has_magnitude(array)) names.push_back(array.name + ":magnitude");
    for (int c = 0; c < array.components; ++c) names.push_back(array.name + ":" + component_name(array, c));
    return names;
}

ScalarName parse_scalar(const Dataset& dataset, const std::string& name) {
    if (const ArrayInfo* array = dataset.find(name)) {
        // A vector's name without a suffix means its magnitude.
        if (array->components == 1 || has_magnitude(*array)) return {array->name, std::nullopt, array->components > 1};
        throw ciel::Error("'" + ciel::printable(name) + "' has " + std::to_string(array->components) +
                          " components and no magnitude; choose one of " + listed(scalar_names(*array)));
    }
    if (const auto [array, suffix] = split(dataset, name); array != nullptr) {
        if (auto scalar = parse_suffix(*array, suffix)) return *scalar;
        throw ciel::Error("array '" + ciel::printable(array->name) + "' has no component '" + ciel::printable(suffix) +
                          "'; choose one of " + listed(scalar_names(*array)));
    }
    std::vector<std::string> names;
    for (const ArrayInfo& array : dataset.info().arrays)
        if (array.association == Association::point)
            for (std::string& each : scalar_names(array)) names.push_back(std::move(each));
    throw ciel::Error("dataset '" + dataset.info().name + "' has no scalar '" + ciel::printable(name) + "'; it has " +
                      (names.empty() ? std::string("none") : listed(names)));
}

std::string cell_scalar(const Dataset& dataset, const std::string& name) {
    const ArrayInfo& array = *dataset.find(parse_scalar(dataset, name).array);
    if (array.association == Association::cell) return name;
    if (array.association != Association::point || array.source.origin == Origin::original ||
        array.source.origin == Origin::derived)
        return {};
    const ArrayInfo* cells = dataset.find("cell:" + array.name);
    const bool is_the_same =
        cells != nullptr && cells->association == Association::cell && cells->components == array.components;
    return is_the_same ? "cell:" + name : std::string();
}

} // namespace server::store
