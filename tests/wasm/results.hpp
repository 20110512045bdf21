// What the extraction records: a name, "mesh / field / what / array", and the array's raw bytes.
#pragma once

#include "ciel/assemble.hpp"
#include "ciel/extract.hpp"
#include "wasm/bytes.hpp"
#include "wasm/cases.hpp"

namespace ciel::test {

class Results {
public:
    explicit Results(Bytes& bytes) : writer_(bytes) {}

    template <typename T>
    void record(const std::string& where, const char* what, std::span<const T> values) {
        writer_(where + " / " + what);
        writer_(values);
    }
    template <typename T>
    void record(const std::string& where, const char* what, const std::vector<T>& values) {
        record(where, what, std::span<const T>(values));
    }
    void record(const std::string& where, const Surface& surface);

private:
    Writer writer_;
};

struct Meshes {
    const Assembled& assembled;
    const Topology& topology;
    [[nodiscard]] FaceMeshView view() const { return assembled.mesh.view(); }
};

inline constexpr std::array<std::pair<const char*, Algorithm>, 3> algorithms{
    {{"signatures", Algorithm::signatures}, {"propagation", Algorithm::propagation}, {"naive", Algorithm::naive}}};

// A field in stored order, with another one to interpolate, to select by or to go on with.
struct FieldPair {
    std::string where;
    std::span<const float> values, others;
    const std::vector<double>& walk;
    const std::vector<double>& other_walk;
    Vec3d slice_origin, slice_normal;
};

// Each algorithm with what a hand may change under it: decider, normals, field, positions; in one history.
void record_changes(const Meshes& meshes, const FieldPair& fields, Results& results);
// Many values in one pass, into each of the sinks.
void record_sweeps(const Meshes& meshes, const FieldPair& fields, Results& results);
// Thresholds, and what is made of surfaces: clipped ones, contour lines, edges.
void record_selections(const Meshes& meshes, const FieldPair& fields, Results& results);

} // namespace ciel::test
