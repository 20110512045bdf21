#include "options.hpp"

namespace ciel::python {

Algorithm algorithm_of(const std::string& name) {
    if (name == "signatures") return Algorithm::signatures;
    if (name == "propagation") return Algorithm::propagation;
    if (name == "naive") return Algorithm::naive;
    throw py::value_error("algorithm is '" + name + "'; use 'signatures', 'propagation' or 'naive'");
}

Decider decider_of(const std::string& name) {
    if (name == "isolate-high") return Decider::isolate_high;
    if (name == "asymptotic") return Decider::asymptotic;
    throw py::value_error("decider is '" + name + "'; use 'isolate-high' or 'asymptotic'");
}

std::optional<Normals> normals_of(const std::optional<std::string>& name) {
    if (!name) return {};
    if (*name == "gradient") return Normals::gradient;
    if (*name == "polygons") return Normals::polygons;
    throw py::value_error("normals is '" + *name + "'; use 'gradient', 'polygons' or None");
}

std::string with_options_text(const char* text) {
    return std::string(text) +
           "\n\nalgorithm: 'signatures', 'propagation' or 'naive'; affects only the time. decider: 'isolate-high' or\n"
           "'asymptotic'; chooses how points on ambiguous faces are joined. normals: 'gradient', 'polygons' or None.\n"
           "blocks: (B,) integers below mesh.block_count, the blocks to cut; None: all blocks. threads: largest\n"
           "number of threads that the call uses; 0: all threads.";
}

} // namespace ciel::python
