#include "support/kept.hpp"
#include "wasm/results.hpp"

namespace ciel::test {
namespace {

// Only one multiplication and one addition each, which round equally on all machines.
std::vector<float> sheared(std::span<const float> positions) {
    std::vector<float> moved(positions.begin(), positions.end());
    for (std::size_t i = 0; i < moved.size(); i += 3) {
        moved[i] += 0.25F * moved[i + 1];
        moved[i + 2] *= 1.5F;
    }
    return moved;
}

class History {
public:
    History(const Meshes& meshes, const FieldPair& fields, Results& results)
        : meshes_(meshes), fields_(fields), results_(results), moved_(sheared(meshes.assembled.mesh.positions)) {}

    void run(const char* name, Algorithm algorithm) {
        name_ = name;
        Field field(meshes_.topology, fields_.values, kept_by_test),
            other(meshes_.topology, fields_.others, kept_by_test);
        Query query(meshes_.topology, kept(meshes_.view()), algorithm);
        query.set_field(field);
        query.set_decider(Decider::asymptotic);
        query.set_normals(Normals::polygons);
        walk(query, fields_.walk, "asymptotic");
        query.set_field(other);
        walk(query, fields_.other_walk, "another field");
        query.set_decider(Decider::isolate_high);
        FaceMeshView moved = kept(meshes_.view());
        moved.positions = moved_;
        query.set_mesh(moved);
        other.vertices_moved();
        walk(query, fields_.other_walk, "moved");
        query.set_normals(Normals::gradient);
        query.set_field(field);
        field.vertices_moved();
        walk(query, fields_.walk, "moved, gradients");
    }

private:
    void walk(Query& query, const std::vector<double>& values, const char* what) {
        for (double nu : values) {
            query.extract(nu, true, surface_);
            results_.record(fields_.where + " / " + what + " / " + name_ + " at " + std::to_string(nu), surface_);
        }
    }

    const Meshes& meshes_;
    const FieldPair& fields_;
    Results& results_;
    std::vector<float> moved_;
    std::string name_;
    Surface surface_;
};

} // namespace

void record_changes(const Meshes& meshes, const FieldPair& fields, Results& results) {
    History history(meshes, fields, results);
    for (const auto& [name, algorithm] : algorithms) history.run(name, algorithm);
}

} // namespace ciel::test
