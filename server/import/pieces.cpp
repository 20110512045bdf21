#include "import/pieces.hpp"

#include "import/corner_index.hpp"

#include <map>

namespace ciel::importer {

namespace {

std::vector<bool> faces_with_name(const FaceMeshView& mesh, const std::vector<Patch>& patches) {
    std::vector<bool> named(mesh.face_count(), false);
    for (const Patch& patch : patches) {
        if (patch.surface == Patch::none_of_them) continue; // a face zone may run along the cut
        for (const Index face : patch.faces) named[face] = true;
    }
    return named;
}

} // namespace

Cut find_cut(const Assembled& pieces, const std::vector<Patch>& patches) {
    const FaceMeshView mesh = pieces.mesh.view();
    const std::vector<bool> named = faces_with_name(mesh, patches);
    CornerIndex index(mesh);
    std::unordered_map<Corners, Index, CornersHash> open;
    Cut cut;
    const auto join = [&](Index a, Index b) {
        std::map<Corners, Index> vertex_at;
        for (const Index vertex : mesh.loop(a)) vertex_at[index.learn({&vertex, 1})] = vertex;
        for (const Index vertex : mesh.loop(b))
            cut.points.emplace_back(pieces.original_vertex[vertex_at.at(index.learn({&vertex, 1}))],
                                    pieces.original_vertex[vertex]);
        ++cut.faces;
    };
    for (Index face = 0; face < mesh.face_count(); ++face) {
        if (mesh.neighbour[face] != none || named[face]) continue;
        const auto [other, is_first] = open.try_emplace(index.learn(mesh.loop(face).unchecked()), face);
        if (is_first) continue;
        join(other->second, face);
        open.erase(other);
    }
    cut.single = open.size();
    return cut;
}

} // namespace ciel::importer
