// Example: makes a mesh from two cubes that are lists of faces, and prints the report. One cube lacks a face and is
// therefore left out.
#include <ciel/contour.hpp>

#include <cstdint>
#include <cstdio>

int main() {
    std::vector<float> points;
    for (const float x : {0.F, 1.F, 2.F})
        for (const float y : {0.F, 1.F})
            for (const float z : {0.F, 1.F}) points.insert(points.end(), {x, y, z});
    const std::vector<std::int32_t> faces{0, 1, 3, 2, 4, 6, 7, 5,  0,  4, 5, 1, 2, 3, 7, 6, 0,  2,  6, 4, 1,  5,
                                          7, 3, 4, 5, 7, 6, 8, 10, 11, 9, 4, 8, 9, 5, 6, 7, 11, 10, 4, 6, 10, 8};
    std::vector<std::int32_t> face_offset{0};
    for (int i = 0; i < 11; ++i) face_offset.push_back(4 * (i + 1));
    const std::vector<std::int32_t> cell_offset{0, 6, 11}; // the second cell has only five faces

    const ciel::Mesh mesh = ciel::Mesh::from_polyhedra({points, 3}, cell_offset, face_offset, faces);
    for (const ciel::BadCells& bad : mesh.report().assembled.bad_cells)
        std::printf("%llu cell left out, the first is cell %u\n", static_cast<unsigned long long>(bad.count),
                    bad.first_ids.front());
    const ciel::Surface cut = ciel::slice(mesh, {0.5, 0, 0}, {1, 0, 0});
    std::printf("%zu polygon in cell %u\n", cut.polygon_cell.size(), cut.polygon_cell.front());
}
