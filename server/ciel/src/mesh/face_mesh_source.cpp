#include "mesh/face_mesh_source.hpp"

#include <algorithm>
#include <numeric>

namespace ciel::detail {

FaceMeshSource::FaceMeshSource(const FaceMeshView& mesh) : mesh_(mesh) {
    check_face_mesh(mesh);
    faces_ = cell_faces(mesh);
}

void FaceMeshSource::copy_own(Index face_begin, Index face_end, FaceLoops& out) const {
    const auto offsets = mesh_.face_offset.unchecked().subspan(face_begin, std::size_t{face_end} - face_begin + 1);
    const std::uint64_t first = offsets.front(), most = mesh_.face_vertex.size();
    out.begin.resize(offsets.size());
    std::uint64_t last = first;
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        const std::uint64_t at = read_once(offsets[i]);
        if (at < last || at > most || at - first >= none) mesh_.face_offset.refuse();
        out.begin[i] = static_cast<Index>((last = at) - first);
    }
    const auto ids = mesh_.face_vertex.unchecked().subspan(first, last - first);
    out.vertex.assign(ids.begin(), ids.end());
    out.mesh_face.resize(face_end - face_begin);
    std::iota(out.mesh_face.begin(), out.mesh_face.end(), face_begin);
    out.mesh_cell.resize(out.mesh_face.size());
    for (Index i = 0; i < out.mesh_cell.size(); ++i)
        out.mesh_cell[i] = {mesh_.owner[face_begin + i], mesh_.neighbour[face_begin + i]};
}

void FaceMeshSource::append(Index face, FaceLoops& out) const {
    const auto ids = mesh_.loop(face).unchecked();
    if (ids.size() >= none - out.vertex.size()) mesh_.face_offset.refuse(); // the corners of a block must fit 32 bits
    out.mesh_face.push_back(face);
    out.mesh_cell.push_back({mesh_.owner[face], mesh_.neighbour[face]});
    out.vertex.insert(out.vertex.end(), ids.begin(), ids.end());
    out.begin.push_back(static_cast<Index>(out.vertex.size()));
}

void FaceMeshSource::list(Index cell_begin, Index cell_end, FaceLoops& out) const {
    const Index face_begin = faces_.own_begin[cell_begin], face_end = faces_.own_begin[cell_end];
    copy_own(face_begin, face_end, out);
    out.cell_loop_begin.assign(1, 0);
    out.cell_loop.clear();
    for (Index cell = cell_begin; cell < cell_end; ++cell) {
        for (const Index face : faces_.others(cell)) {
            const Index loop = face >= face_begin ? face - face_begin : out.loop_count();
            if (face < face_begin) append(face, out);
            if (out.mesh_cell[loop][1] != cell) mesh_.neighbour.refuse();
            out.cell_loop.push_back(2 * loop + 1);
        }
        for (Index loop = faces_.own_begin[cell] - face_begin; loop < faces_.own_begin[cell + 1] - face_begin; ++loop) {
            if (out.mesh_cell[loop][0] != cell) mesh_.owner.refuse();
            out.cell_loop.push_back(2 * loop);
        }
        out.cell_loop_begin.push_back(static_cast<Index>(out.cell_loop.size()));
    }
}

} // namespace ciel::detail
