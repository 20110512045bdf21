// Input meshes and fields for all machines. The native build writes them to a file, because random numbers, shuffles
// and exponentials differ between standard libraries.
#pragma once

#include "support/polyhedra.hpp"

#include <string>

namespace ciel::test {

struct CaseField {
    std::string name;
    std::vector<float> values; // one value for each vertex of the input
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
