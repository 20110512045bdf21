// What every machine gets to extract. The native build writes it: random numbers, shuffles and exponentials differ from
// one standard library to the next, so meshes and fields made on the spot would not be the same.
#pragma once

#include "support/polyhedra.hpp"

#include <string>

namespace ciel::test {

struct CaseField {
    std::string name;
    std::vector<float> values; // of the input's vertices
    std::vector<double> walk;

    template <typename Archive>
    void parts(Archive& archive) {
        archive(name);
        archive(values);
        archive(walk);
    }
};

struct Case {
    std::string name;
    Polyhedra mesh;
    std::vector<CaseField> fields;
    Point slice_origin{}, slice_normal{};
    std::vector<double> slice_walk;

    template <typename Archive>
    void parts(Archive& archive) {
        archive(name);
        archive(mesh.origin);
        archive(mesh.positions);
        archive(mesh.cell_types);
        archive(mesh.cell_offset);
        archive(mesh.face_offset);
        archive(mesh.face_vertex);
        std::uint64_t field_count = fields.size();
        archive(field_count);
        fields.resize(field_count);
        for (CaseField& field : fields) field.parts(archive);
        archive(slice_origin);
        archive(slice_normal);
        archive(slice_walk);
    }
};

} // namespace ciel::test
