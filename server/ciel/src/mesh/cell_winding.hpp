// CellWinding: checks that a polyhedron is closed, and finds the faces that must be reversed so that all normals point
// outwards. Finds mates as the paper does (appendix A).
#pragma once

#include "mesh/input_faces.hpp"

#include <optional>

namespace ciel::detail {

// Each thread needs its own object. The input must outlive the object. For a bad cell, `judge` does not throw; the
// Verdict has the reason.
class CellWinding {
public:
    explicit CellWinding(const InputFaces& input);

    struct Verdict {
        std::optional<BadCells::Reason> bad;
        double volume = 0; // absolute value
        Vec3d center{};    // mean of the cell's vertices
    };
    // Sets `turn[f]` to 1 for each input face of the cell that must be reversed to point outwards, else to 0.
    Verdict judge(Index cell, std::span<std::uint8_t> turn);

    // Returns the lobe of each face of a closed cell. A lobe is a closed set of faces, so it can be reversed alone. A
    // cell has several lobes if it touches itself along an edge or surrounds a cavity.
    [[nodiscard]] std::vector<Index> lobes(Index cell);

private:
    struct Face {
        Index id;         // input face
        Index begin, end; // range of the half-edges of the face in from_
        bool turned = false;
    };

    bool gather(Index cell); // returns false when a vertex id is out of range
    void forget();
    bool balanced();
    bool balanced_when_sorted(); // like balanced, in O(n log n); overwrites uses_
    std::optional<BadCells::Reason> make_agree();
    bool collect_edges();
    Index spread_winding();
    void join_open_lobes(Index count);
    Index joined(Index lobe);
    [[nodiscard]] Index target(Index half_edge) const;
    [[nodiscard]] Vec3d position(Index local) const;
    [[nodiscard]] Vec3d center() const;
    [[nodiscard]] double signed_volume(const Vec3d& center) const;

    const InputFaces& input_;
    std::vector<Index> local_of_; // input vertex -> local vertex; none if not in this cell
    std::vector<Index> vertices_; // local vertex -> input vertex
    std::vector<Face> faces_;     // the cell's faces that have at least three vertices
    std::vector<Index> from_;     // half-edge -> local vertex that it leaves
    std::vector<Index> face_of_;  // half-edge -> index in faces_
    std::vector<Index> loop_;     // scratch: input vertices of one face
    std::vector<Index> head_;     // local vertex -> first half-edge in the list of half-edges that leave it
    std::vector<Index> next_;     // half-edge -> next half-edge in the same list
    std::vector<std::uint8_t> paired_;
    std::vector<Index> lobe_;      // face -> lobe; faces that share an edge with no third face are in the same lobe
    std::vector<Index> joined_to_; // lobe -> its parent in the union-find tree; a root is its own parent
    struct Use {
        Index low, high, face;
        bool upward;
    };
    std::vector<Use> uses_; // half-edges sorted by edge
    Index lobe_at(const Use& use) { return joined(lobe_[use.face]); }
    struct Neighbour {
        Index face;
        bool same_direction;
    };
    std::vector<std::vector<Neighbour>> neighbours_; // face -> adjacent faces across edges of exactly two faces
};

} // namespace ciel::detail
