// The options of contour.hpp as keywords of Python. Not in the paper.
#pragma once

#include "module.hpp"

#include <string>

namespace ciel::python {

// Throws ValueError for an unknown name.
[[nodiscard]] Algorithm algorithm_of(const std::string& name);
[[nodiscard]] Decider decider_of(const std::string& name);
[[nodiscard]] std::optional<Normals> normals_of(const std::optional<std::string>& name);

[[nodiscard]] std::string with_options_text(const char* text);

// Returns a function like `f`. Instead of an Options object, the function has one parameter for each option, after the
// other parameters.
template <class Result, class... Args>
[[nodiscard]] auto with_options(Result (*f)(const Options&, Args...)) {
    return [f](Args... args, const std::string& algorithm, const std::string& decider,
               const std::optional<std::string>& normals, const std::optional<std::vector<Index>>& blocks,
               unsigned threads) {
        const Options options{algorithm_of(algorithm), decider_of(decider), normals_of(normals), blocks, threads};
        return f(options, std::forward<Args>(args)...);
    };
}

// Calls `define` with a py::arg for each option; `define` must pass these arguments to pybind11's def().
template <class Define>
void with_option_keywords(const Define& define) {
    define(py::arg("algorithm") = "signatures", py::arg("decider") = "isolate-high", py::arg("normals") = "gradient",
           py::arg("blocks") = py::none(), py::arg("threads") = 0);
}

} // namespace ciel::python
