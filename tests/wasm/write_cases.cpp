// wasm_cases FILE: writes the cases for all machines.
#include "support/fields.hpp"
#include "support/meshes.hpp"
#include "wasm/bytes.hpp"
#include "wasm/cases.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <limits>

namespace ciel::test {
namespace {

constexpr int walk_steps = 4;

std::vector<float> with_holes(std::vector<float> values) {
    for (std::size_t v = 5; v < values.size(); v += 23) values[v] = std::numeric_limits<float>::quiet_NaN();
    return values;
}

std::vector<CaseField> fields(const Polyhedra& mesh) {
    std::vector<CaseField> result;
    for (const NamedField& field : all_fields()) {
        if (field.name == "constant" || field.name == "two_valued" || field.name == "along_x") continue;
        const std::vector<float> values = field.make(mesh);
        result.push_back({field.name, values, walk_through(values, walk_steps, 51)});
    }
    const std::vector<float> whole = bumps_field(mesh, 52);
    result.push_back({"bumps_with_holes", with_holes(whole), walk_through(whole, walk_steps, 53)});
    return result;
}

// Slices through the middle, by a plane that is not parallel to any face of a lattice.
Case make_case(const std::string& name, const Polyhedra& mesh) {
    Point middle{};
    for (Id v = 0; v < mesh.vertex_count(); ++v) {
        for (std::size_t d = 0; d < 3; ++d) middle[d] += mesh.position(v)[d] / mesh.vertex_count();
    }
    return {name, mesh, fields(mesh), middle, {0.6, -0.48, 0.64}, {-0.5, -0.1, 0, 0.07, 0.8}};
}

Polyhedra moved_to(const Point& origin, Polyhedra mesh) {
    mesh.origin = origin;
    return mesh;
}

std::vector<Case> all_cases() {
    const Polyhedra mixed = zoo({{4, 4, 4}, 0.1, 54});
    std::vector<Case> cases;
    for (const NamedMesh& mesh : all_meshes()) cases.push_back(make_case(mesh.name, mesh.make()));
    cases.push_back(make_case("turned", with_turned_cells(with_turned_faces(mixed, 0.2, 55), 0.2, 56)));
    cases.push_back(make_case("far_away", moved_to({512000.25, 4649776.5, -1200.125}, mixed)));
    // Enough cells for the native build's parallel loops to split.
    cases.push_back(make_case("large", zoo({{12, 12, 12}, 0.1, 57})));
    cases.back().fields.resize(1);
    return cases;
}

} // namespace
} // namespace ciel::test

int main(int count, char** arguments) {
    using namespace ciel::test;
    if (count != 2) {
        std::cerr << "wasm_cases: give the file to write\n";
        return 2;
    }
    Bytes bytes;
    Writer writer(bytes);
    for (Case& made : all_cases()) made.parts(writer);
    std::ofstream file(arguments[1], std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return file.flush() ? 0 : 1;
}
