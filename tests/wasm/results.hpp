// Records results of the extraction: a name, "mesh / field / operation / array", and the array's bytes.
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

// A field in stored vertex order, and a second one for interpolation, selection and changes of the field.
struct FieldPair {
    std::string where;
    std::span<const float> values, others;
    const std::vector<double>& walk;
    const std::vector<double>& other_walk;
    Vec3d slice_origin, slice_normal;
};

// Runs each algorithm through a sequence of changes: decider, normals, field, positions.
void record_changes(const Meshes& meshes, const FieldPair& fields, Results& results);
// Sweeps over many values in one pass, into each kind of sink.
void record_sweeps(const Meshes& meshes, const FieldPair& fields, Results& results);
// Thresholds, clipped surfaces, contour lines and edges.
void record_selections(const Meshes& meshes, const FieldPair& fields, Results& results);

} // namespace ciel::test
